// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// The open problems of the thesis, chapter 11: schemes of second order for any stick ratio and any
/// alignment of the grid, schemes whose results do not depend on the step, and the number of digits
/// of a reference.
struct OpenProblemsParameters {
  Material material;
  double length = 0;                  ///< L0 of plane strain  [mm]
  PolynomialBound bound;              ///< of the steady cases
  std::vector<Eigen::Index> sizes{};  ///< N, each twice its predecessor
  int cases = 0;                      ///< number of combinations of stick ratio and alignment, >= 1
  std::vector<double> stick_ratios{};    ///< least and largest a', in (0, 1)
  Eigen::Index steady_elements = 0;      ///< of the case for all steps
  double steady_stick_ratio = 0;         ///< a' there, in (0, 1)
  std::vector<double> steady_ratios{};   ///< c there, one of them 1
  Eigen::Index motion_elements = 0;      ///< of the transient
  double force = 0;                      ///< of the transient [N/mm]
  Eigen::Index distance = 0;             ///< rolled, in elements
  Eigen::Index refinement = 0;           ///< elements of the reference for each element, >= 2
  std::vector<double> motion_ratios{};   ///< c, each in [1e-4, 5], one of them 1
  std::vector<double> widths{};          ///< of strips  [half-widths]
  int curve_points = 0;                  ///< >= 2
  std::vector<Eigen::Index> unknowns{};  ///< of the Chebyshev collocation, each 1 to 63
};

/// The keys that `open_problems --print-keys` lists, each checked against its listed range.
OpenProblemsParameters read_open_problems(Scene& scene);

/// Tables: cases (every error), errors (their spread against N), orders, steady_steps (error
/// against c), steps (traction after rolling, against c), traction (of some of them), curve
/// (creepage and force), digits (against unknowns), schemes (recommended for each purpose), claims.
std::vector<Table> open_problems(const OpenProblemsParameters& parameters,
                                 const Progress& progress);

}  // namespace microslip::experiments
