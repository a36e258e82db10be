// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Do fractional powers of A^-1 A* keep travelling peaks sharp, and is their cost a reason to
/// reject them? Thesis chapter 8.
struct FractionalPowerParameters {
  CattaneoToCarter rolling;           ///< odd number of elements
  std::vector<double> step_ratios{};  ///< c of Fig. 8.3, each >= 1e-6, the first a whole number
  std::vector<double> distances{};    ///< in elements: of Figs. 8.3 and 8.4
  double step_ratio = 0;              ///< c in all other tables, in (0, 1)
  Eigen::Index refinement = 0;        ///< elements of the reference for each element, >= 2
  Eigen::Index shape_elements = 0;    ///< of Figs. 8.1 and 8.2, odd, >= 51
  std::vector<Eigen::Index> steps{};  ///< after which shapes are shown, rising
  std::vector<Eigen::Index> cost_sizes{};  ///< N, odd
  Eigen::Index largest_schur = 0;  ///< N up to which the Schur method is tried, >= 3 of them
};

/// The keys that `fractional_power --print-keys` lists, each checked against its listed range.
FractionalPowerParameters read_fractional_power(Scene& scene);

/// Tables: shapes and shapes_summary (Figs. 8.1 and 8.2), traction, reference and summary (Figs.
/// 8.3 and 8.4), eigenvalues (for an odd and an even number of elements), agreement (of the action
/// on a vector with a Schur method, which is itself checked), cost (counted), cost_timing
/// (measured), claims.
std::vector<Table> fractional_power(const FractionalPowerParameters& parameters,
                                    const Progress& progress);

}  // namespace microslip::experiments
