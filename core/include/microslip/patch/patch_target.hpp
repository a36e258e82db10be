// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/patch/patch_grid.hpp"
#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// A solution on the grid that was chosen, and an estimate of its error.
struct EstimatedPatch {
  SteadyPatch problem;  ///< with the rows and elements that were chosen
  SteadyPatchSolution solution;
  /// Estimate of the error of the solution in the measure of change_of(). It is meant as an upper
  /// limit of the right size: tests/property/generated_patch_targets_test.cpp  [1]
  double error;
};

/// The grids that are tried, from coarse to fine. Each fits the shape, and has twice as many cells as
/// the one before; the last one has at most some 1700 cells.
std::vector<PatchGrid> grids_to_try(const PatchShape& shape);

/// Solves steady rolling of a patch on finer and finer grids, until the estimate of the error is
/// below the target.
///
/// The estimate is a sum of two terms. The one is the largest of three changes: from half as many
/// cells, from a quarter of them (half of that change), and from one row and one element less, as
/// errors alternate with the number of elements; twice that below 16 by 16 cells. The other is the
/// effect of slip zones at the trailing edge that are too short for the cells there.
/// \param problem  its rows and elements are not used
/// \param target   in [1e-11, 0.1]  [1]
/// \throws std::invalid_argument as validate(), and for targets out of their range
/// \throws NotConverged          if the target is not reached
EstimatedPatch solve_steady_to(const SteadyPatch& problem, double target);

}  // namespace microslip
