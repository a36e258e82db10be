// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Does under-relaxation remove the wiggles of small steps, and at what price? Thesis 7.1, on the
/// Cattaneo shift that turns to Carter's solution.
struct UnderRelaxationParameters {
  CattaneoToCarter rolling;
  double relaxation = 0;              ///< c*, at least each c below
  std::vector<double> step_ratios{};  ///< c of the tractions shown, each >= 1e-6; the first is c*
  std::vector<double> distances{};    ///< in elements, ascending: of Figs. 7.1 and 7.2
  Eigen::Index refinement = 0;        ///< elements of the reference for each element, >= 2
  double compared_step_ratio = 0;     ///< c at which (7.4) and (7.10) are compared
  Eigen::Index small_elements = 0;    ///< of the grid on which wiggles are counted
  std::vector<double> relaxed_step_ratios{};  ///< c on that grid, falling, each >= 1e-6
  std::vector<double> direct_step_ratios{};   ///< c of the direct scheme on that grid, falling
};

/// The keys that `under_relaxation --print-keys` lists, each checked against its listed range.
UnderRelaxationParameters read_under_relaxation(Scene& scene);

/// Tables: traction and reference (Figs. 7.1 and 7.2), summary (errors), wiggles (local extrema
/// against c), comparison (of (7.4) and (7.10) against the distance), parting (tractions of both
/// where they first differ), claims.
std::vector<Table> under_relaxation(const UnderRelaxationParameters& parameters,
                                    const Progress& progress);

}  // namespace microslip::experiments
