// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/steady.hpp"

#include <algorithm>

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

SteadySolution by_differences(const SteadyProblem& problem, const Differences& differences) {
  const auto& [kernel, bound, grid, basis, method, load] = problem;
  const auto& [step_ratio, edge_displacement] = differences;
  const Index n = grid.size();
  const double dx = grid.spacing();
  const VectorXd x = grid.nodes();
  const Eigen::MatrixXd influence = influence_matrix(kernel, basis, dx, n);
  Eigen::MatrixXd strain =
      influence_difference_matrix(kernel, basis, dx, n, step_ratio) / (step_ratio * dx);
  SlipConditions conditions{
      .bound = bound_at(bound, x), .offset = VectorXd::Zero(n), .reference = VectorXd::Zero(n)};
  if (edge_displacement) {
    const double to_edge = grid.leading_offset() * dx;
    require(to_edge > 0, "grid.leading_offset", grid.leading_offset(),
            "a number > 0 where the displacement at the leading edge is known");
    strain.row(n - 1) = influence.row(n - 1) / to_edge;
    conditions.offset[n - 1] = -*edge_displacement / to_edge;
  }
  const VectorXd weights = basis.weights(dx, n);
  const ContactState state = ActiveSet(strain, weights).solve(conditions, load);
  return {.x = x,
          .bound = conditions.bound,
          .traction = state.traction,
          .slip = state.slip,
          .displacement = influence * state.traction,
          .zones = state.zones,
          .force = weights.dot(state.traction),
          .creepage = state.creepage,
          .dissipation = -weights.cwiseProduct(state.traction).dot(state.slip),
          .iterations = state.iterations};
}

/// \param solution  as functions of x, with one stick zone
template <class Solution>
SteadySolution sampled(const SteadyProblem& problem, const Solution& solution, int iterations) {
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
      .iterations = iterations,
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
    return sampled(problem, solution, solution.evaluations());
  }
  CalibratedRolling rolling(problem.kernel, problem.bound, problem.basis, problem.grid.size());
  const CalibratedSolution solution = rolling.solve(problem.load);
  if (solution.violation() > another_zone) return with_several_zones(problem);
  return sampled(problem, solution, solution.evaluations());
}

}  // namespace microslip
