// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_target.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "microslip/rolling/target_error.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "patch_scale.hpp"

namespace microslip {

using Eigen::Index;

namespace {

/// Cells of a side of a circle in the coarsest and the finest grid.
constexpr double coarsest_side = 4, finest_side = 32;
/// The least number of grids, so that changes from two are known.
constexpr std::size_t fewest_grids = 3;
/// The number of the first grid on which the order of errors shows: 16 by 16 on a circle. What it
/// does not solve, friction hardly carries.
constexpr std::size_t solving_grid = 4;
/// A target is not tried for if second order reaches this many times as much on the finest grid.
constexpr double hopeless = 4;
/// Motions have this relative rounding error.
constexpr double rounding = 1e-8;

/// The part of the motion, over all of it, by slip that the cells do not resolve. If a row slips over
/// the length q a, in parts of its half-length, as in Carter's solution, then its force over its
/// creepage is q/4 less than without slip. In a row whose last cell sticks, the traction of adhesion
/// is 2/e times a constant at the distance e^2/2 a from the trailing edge, and the bound is e times
/// one. The zone is twice as long as that up to where the two are equal.
double unresolved_slip(const SteadyPatchSolution& solution, const JoinedRows& rows) {
  const double e = std::numbers::pi / (2 * static_cast<double>(rows.elements()));
  double unresolved = 0, all = 0;
  for (Index k = 0; k < rows.rows(); ++k) {
    double force = 0;
    for (Index i = 0; i < rows.elements(); ++i) {
      force += solution.area[rows.cell(i, k)] * solution.traction.row(rows.cell(i, k)).norm();
    }
    all += force;
    const Index last = rows.cell(rows.elements() - 1, k);
    if (solution.slips[static_cast<std::size_t>(last)]) continue;
    const double used = solution.traction.row(last).norm() / solution.bound[last];
    unresolved += force * used * e * e / 4;
  }
  return all > 0 ? unresolved / all : 0;
}

/// Turns a part of all motions into an error by change_of(): under a resultant the motion follows,
/// and under motions alone the resultants.
double cost_of(const SteadyPatch& problem, const SteadyPatchSolution& solution, double part) {
  double largest = 0;
  for (std::size_t j = 0; j < problem.load.size(); ++j) {
    if (problem.load[j].by_resultant && problem.load[j].value != 0) return part;
    const double most = j < 2 ? problem.bound.total() : problem.bound.turning_moment();
    largest = std::max(largest, std::abs(solution.resultants[static_cast<Index>(j)]) / most);
  }
  return part * largest;
}

struct OnGrid {
  SteadyPatchSolution solution;
  double cost;  ///< of slip that is not resolved
};

OnGrid solved_on(const SteadyPatch& problem) {
  const PatchResponse response(rows_of(problem), problem.material.poisson_ratio);
  SteadyPatchSolution solution = solve_steady(problem, response);
  const double part = unresolved_slip(solution, response.rows());
  return {std::move(solution), cost_of(problem, solution, part)};
}

/// The problem with one row and one element less; where there is none to spare, with one more.
SteadyPatch neighbour_of(SteadyPatch problem) {
  const auto lobes = static_cast<Index>(problem.bound.shape().lobes().size());
  problem.rows += problem.rows > lobes ? -1 : 1;
  problem.elements += problem.elements > least_elements ? -1 : 1;
  return problem;
}

std::optional<OnGrid> if_solved(const SteadyPatch& problem) {
  try {
    return solved_on(problem);
  } catch (const NotConverged&) {
    return std::nullopt;
  }
}

using Solutions = std::vector<std::optional<SteadyPatchSolution>>;

bool has_any(const Solutions& solutions) {
  return std::ranges::any_of(solutions, [](const auto& one) { return one.has_value(); });
}

/// Computes the estimate of the error on grid number k, or a part of it that is above the target.
/// Before the order of errors shows, changes are multiplied by a factor.
double error_of(const SteadyPatch& tried, std::size_t k, const OnGrid& found,
                const Solutions& coarser, double target) {
  constexpr double of_coarse = 2, of_slip = 3;
  const double factor = k < solving_grid ? of_coarse : 1;
  double largest = change_of(tried, *coarser[k - 1], found.solution);
  if (coarser[k - 2]) {
    largest = std::max(largest, change_of(tried, *coarser[k - 2], found.solution) / 2);
  }
  const double rest = of_slip * found.cost + rounding;
  if (factor * largest + rest > target) return factor * largest + rest;
  const auto other = if_solved(neighbour_of(tried));
  if (!other) return std::numeric_limits<double>::infinity();
  largest = std::max(largest, change_of(tried, other->solution, found.solution));
  return factor * largest + rest;
}

}  // namespace

std::vector<PatchGrid> grids_to_try(const PatchShape& shape) {
  constexpr Index most_cells = 1700;
  const auto lobes = static_cast<Index>(shape.lobes().size());
  const PatchGrid finest = fitting_grid(shape, finest_side);
  std::vector<PatchGrid> grids;
  for (double side = coarsest_side; side < 1.01 * finest_side; side *= std::numbers::sqrt2) {
    PatchGrid grid = fitting_grid(shape, side);
    // Where the finest grid would have too many rows, all have fewer.
    if (finest.rows == most_cells_of_side) {
      grid.rows = std::lround(static_cast<double>(most_cells_of_side) * side / finest_side);
    }
    grid.rows = std::clamp(grid.rows, lobes, most_cells_of_side);
    grid.elements = std::max(grid.elements, least_elements);
    if (grid.rows * grid.elements > most_cells) break;
    grids.push_back(grid);
  }
  return grids;
}

EstimatedPatch solve_steady_to(const SteadyPatch& problem, double target) {
  require_target_error(target);
  const std::vector<PatchGrid> grids = grids_to_try(problem.bound.shape());
  std::vector<std::optional<SteadyPatchSolution>> solutions;
  double expected = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < grids.size(); ++k) {
    SteadyPatch tried = problem;
    tried.rows = grids[k].rows;
    tried.elements = grids[k].elements;
    solutions.emplace_back();
    const bool may_fail = k + 1 < grids.size() && (k < solving_grid || has_any(solutions));
    auto found = may_fail ? if_solved(tried) : std::make_optional(solved_on(tried));
    if (!found) continue;
    solutions.back() = found->solution;
    if (k + 1 < fewest_grids || !solutions[k - 1]) continue;
    const double error = error_of(tried, k, *found, solutions, target);
    if (error <= target) {
      found->solution.evidence.change = change_of(tried, *solutions[k - 1], found->solution);
      return {std::move(tried), std::move(found->solution), error};
    }
    expected = error / std::pow(2, static_cast<double>(grids.size() - 1 - k));
    if (k >= solving_grid && expected > hopeless * target) break;
  }
  const PatchGrid& finest = grids.back();
  if (!std::isfinite(expected)) {
    throw NotConverged(
        fmt::format("target_error = {}: stick and slip are not found on enough grids for an "
                    "estimate of the error; grid.rows and grid.elements instead choose one",
                    format_short(target)),
        0, 1);
  }
  throw NotConverged(
      fmt::format("target_error = {}: expected about {} or more here, which {} rows of {} "
                  "elements reach; finer grids are not tried",
                  format_short(target), format_apart(expected, target).first, finest.rows,
                  finest.elements),
      0, expected);
}

}  // namespace microslip
