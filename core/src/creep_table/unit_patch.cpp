// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/creep_table/unit_patch.hpp"

#include <cmath>
#include <numbers>

#include "../patch/patch_scale.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip {

using Eigen::Index;

namespace {

SteadyPatch unit_patch(double ratio, double poisson_ratio, Index cells) {
  const EllipticBound bound(std::sqrt(ratio), 1 / std::sqrt(ratio), 1);
  const PatchGrid grid = fitting_grid(PatchBound(bound).shape(), static_cast<double>(cells));
  return {.material = {.shear_modulus = 1, .poisson_ratio = poisson_ratio},
          .bound = bound,
          .rows = grid.rows,
          .elements = grid.elements};
}

}  // namespace

UnitPatch::UnitPatch(double ratio, double poisson_ratio, Index cells)
    : problem_(unit_patch(ratio, poisson_ratio, cells)),
      response_(rows_of(problem_), poisson_ratio) {}

UnitPatch::Solution UnitPatch::solve(const Eigen::Vector3d& motion, const PatchState* start) const {
  SteadyPatch problem = problem_;
  for (std::size_t c = 0; c < problem.load.size(); ++c) {
    problem.load[c].value = motion[static_cast<Index>(c)];
  }
  SteadyPatchSolution solution = solve_steady(problem, response_, start);
  return {solution.resultants / (2 * std::numbers::pi / 3), std::move(solution.state)};
}

std::optional<Eigen::Vector3d> UnitPatch::forces(const Eigen::Vector3d& motion,
                                                 std::optional<PatchState>& state) const {
  for (const bool from_state : {true, false}) {
    if (from_state && !state) continue;
    try {
      Solution found = solve(motion, from_state ? &*state : nullptr);
      state = std::move(found.state);
      return found.forces;
    } catch (const NotConverged&) {
      continue;
    }
  }
  state.reset();
  return std::nullopt;
}

}  // namespace microslip
