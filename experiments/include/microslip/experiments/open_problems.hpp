// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// What the thesis left open, chapter 11: which schemes are second order for any adhesion and any
/// alignment of the grid, which give the same for any step, and how many digits a reference has.
struct OpenProblemsParameters {
  Material material;
  double length;                      ///< L0 of plane strain  [mm]
  PolynomialBound bound;              ///< of the steady cases
  std::vector<Eigen::Index> sizes;    ///< N, each twice the one before
  int cases;                          ///< of adhesion and alignment, >= 1
  double least_stick_ratio;           ///< a', in (0, 1)
  double most_stick_ratio;            ///< likewise, above that
  Eigen::Index steady_elements;       ///< of the case for all steps
  double steady_stick_ratio;          ///< a' there, in (0, 1)
  std::vector<double> steady_ratios;  ///< c there, one of them 1
  CattaneoToCarter motion;
  double distance;                     ///< rolled, in elements
  Eigen::Index refinement;             ///< elements of the reference for each one, >= 2
  std::vector<double> motion_ratios;   ///< c, each in [1e-4, 5], one of them 1
  std::vector<double> widths;          ///< of strips  [half-widths]
  int curve_points;                    ///< >= 2
  std::vector<Eigen::Index> unknowns;  ///< of the Chebyshev collocation, each 1 to 63
};

/// The keys that `open_problems --print-keys` lists, each held to what that says it accepts.
OpenProblemsParameters read_open_problems(Scene& scene);

/// Tables: cases (every error), errors (their spread against N), orders, steady_steps (error
/// against c), steps (traction after rolling, against c), traction (of some of them), curve
/// (creepage and force), digits (against unknowns), schemes (which for which need), claims.
std::vector<Table> open_problems(const OpenProblemsParameters& parameters,
                                 const Progress& progress);

}  // namespace microslip::experiments
