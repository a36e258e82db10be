// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/steady.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/calibrated_rolling.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/support/require.hpp"
#include "several_zones.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

Index SteadySolution::adhesion_elements() const {
  return std::count(zones.begin(), zones.end(), Zone::adhesion);
}

Index SteadySolution::slip_elements() const { return x.size() - adhesion_elements(); }

namespace {

/// Violations of the contact conditions that are no error of discretisation: there is more than one
/// stick zone.
constexpr double another_zone = 1e-3;

/// -du/dx of the tractions, the last row of which may have been replaced.
SquareMatrix strain_of(const SteadyProblem& problem, const Differences& differences) {
  const auto& [kernel, bound, grid, basis, method, load, solver] = problem;
  const Index n = grid.size();
  const double dx = grid.spacing();
  if (!differences.edge_displacement) {
    return strain_operator(kernel, basis, dx, n, differences.step_ratio, solver);
  }
  if (solver.type == Solver::Type::fft) {
    throw std::invalid_argument(
        "solver.type = 'fft': expected auto or dense where the displacement at the leading edge is "
        "known");
  }
  require_dense(n);
  Eigen::MatrixXd strain =
      influence_difference_matrix(kernel, basis, dx, n, differences.step_ratio) /
      (differences.step_ratio * dx);
  const double to_edge = grid.leading_offset() * dx;
  require(to_edge > 0, "grid.leading_offset", grid.leading_offset(),
          "a number > 0 where the displacement at the leading edge is known");
  for (Index j = 0; j < n; ++j) {
    const ShapeFunction& shape = basis.shapes()[basis.shape_of(j, n)];
    strain(n - 1, j) = influence(kernel, shape, dx, static_cast<double>(n - 1 - j)) / to_edge;
  }
  return strain;
}

ActiveSet active_set_of(const SteadyProblem& problem, const Differences& differences) {
  const Grid& grid = problem.grid;
  return {strain_of(problem, differences), problem.basis.weights(grid.spacing(), grid.size()),
          problem.solver};
}

ContactState contact_by(ActiveSet& active_set, const SteadyProblem& problem,
                        const Differences& differences);

std::vector<Zone> zones_of(const SteadyProblem& problem, const Differences& differences) {
  ActiveSet active_set = active_set_of(problem, differences);
  return contact_by(active_set, problem, differences).zones;
}

/// Where to start from: adhesion everywhere; or the partition of a grid of fewer elements, so that
/// the number of rounds does not grow with that of elements; or, for small steps, that of a whole
/// one, from which it differs by few elements: from adhesion, the way would be long.
std::vector<Zone> first_zones(const SteadyProblem& problem, const Differences& differences) {
  constexpr Index ratio = 4;
  constexpr Index coarsest = 50;
  const Index n = problem.grid.size();
  if (differences.step_ratio < 1) {
    Differences whole = differences;
    whole.step_ratio = 1;
    return zones_of(problem, whole);
  }
  if (n < ratio * coarsest) return std::vector<Zone>(static_cast<std::size_t>(n), Zone::adhesion);
  SteadyProblem coarse = problem;
  coarse.grid = problem.grid.with_elements(n / ratio);
  const std::vector<Zone> known = zones_of(coarse, differences);
  const VectorXd x = problem.grid.nodes();
  const VectorXd coarse_x = coarse.grid.nodes();
  std::vector<Zone> zones;
  for (Index i = 0; i < n; ++i) {
    const double place = std::round((x[i] - coarse_x[0]) / coarse.grid.spacing());
    const double nearest = std::clamp(place, 0.0, static_cast<double>(coarse_x.size() - 1));
    zones.push_back(known[static_cast<std::size_t>(nearest)]);
  }
  return zones;
}

ContactState contact_by(ActiveSet& active_set, const SteadyProblem& problem,
                        const Differences& differences) {
  const Grid& grid = problem.grid;
  const Index n = grid.size();
  SlipConditions conditions{.bound = bound_at(problem.bound, grid.nodes()),
                            .offset = VectorXd::Zero(n),
                            .reference = VectorXd::Zero(n)};
  if (differences.edge_displacement) {
    conditions.offset[n - 1] =
        -*differences.edge_displacement / (grid.leading_offset() * grid.spacing());
  }
  return active_set.solve(conditions, problem.load, first_zones(problem, differences));
}

SteadySolution by_differences(const SteadyProblem& problem, const Differences& differences) {
  const Grid& grid = problem.grid;
  const Index n = grid.size();
  const VectorXd x = grid.nodes();
  ActiveSet active_set = active_set_of(problem, differences);
  const ContactState state = contact_by(active_set, problem, differences);
  const VectorXd weights = problem.basis.weights(grid.spacing(), n);
  return {.x = x,
          .bound = bound_at(problem.bound, x),
          .traction = state.traction,
          .slip = state.slip,
          .displacement =
              influence_operator(problem.kernel, problem.basis, grid.spacing(), n, problem.solver) *
              state.traction,
          .zones = state.zones,
          .force = weights.dot(state.traction),
          .creepage = state.creepage,
          .dissipation = -weights.cwiseProduct(state.traction).dot(state.slip),
          .iterations = state.iterations,
          .evidence = state.evidence,
          .condition = active_set.condition()};
}

/// \param solution  as functions of x, with one stick zone
template <class Solution>
SteadySolution sampled(const SteadyProblem& problem, const Solution& solution,
                       const Evidence& evidence) {
  const VectorXd x = problem.grid.nodes();
  SteadySolution state{
      .x = x,
      .bound = bound_at(problem.bound, x),
      .traction = x.unaryExpr([&](double xi) { return solution.traction(xi); }),
      .slip = x.unaryExpr([&](double xi) { return solution.slip(xi); }),
      .displacement = x.unaryExpr([&](double xi) { return solution.displacement(xi); }),
      .zones = {},
      .force = solution.force(),
      .creepage = solution.creepage(),
      .dissipation = solution.dissipation(),
      .iterations = solution.evaluations(),
      .evidence = evidence,
      .condition = solution.condition(),
      .stick_edge = solution.stick_edge()};
  const Zone slipping = solution.creepage() < 0 ? Zone::slip_positive : Zone::slip_negative;
  for (const double xi : x) state.zones.push_back(solution.sticks(xi) ? Zone::adhesion : slipping);
  return state;
}

}  // namespace

SteadySolution solve_steady(const SteadyProblem& problem) {
  if (const auto* differences = std::get_if<Differences>(&problem.method)) {
    return by_differences(problem, *differences);
  }
  if (std::holds_alternative<ChebyshevCollocation>(problem.method)) {
    const ChebyshevRolling rolling(problem.kernel, problem.bound);
    const ChebyshevSolution solution = rolling.solve(problem.load);
    return sampled(problem, solution, solution.evidence());
  }
  CalibratedRolling rolling(problem.kernel, problem.bound, problem.basis, problem.grid.size(),
                            problem.solver);
  const CalibratedSolution solution = rolling.solve(problem.load);
  const Evidence evidence = solution.evidence();
  const bool one_zone = evidence.violation() <= another_zone;
  return one_zone ? sampled(problem, solution, evidence) : with_several_zones(problem);
}

}  // namespace microslip
