// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/steady.hpp"

#include <algorithm>

#include "microslip/halfspace/influence.hpp"

namespace microslip {

Eigen::Index SteadySolution::adhesion_elements() const {
  return std::count(zones.begin(), zones.end(), Zone::adhesion);
}

Eigen::Index SteadySolution::slip_elements() const { return x.size() - adhesion_elements(); }

SteadySolution solve_steady(const SteadyProblem& problem) {
  const auto& [kernel, bound, grid, basis, step_ratio, load] = problem;
  const Eigen::Index n = grid.size();
  const double dx = grid.spacing();
  const Eigen::VectorXd x = grid.nodes();
  const SlipEquations equations{
      .response = influence_difference_matrix(kernel, basis, dx, n, step_ratio) / (step_ratio * dx),
      .offset = Eigen::VectorXd::Zero(n),
      .bound = bound(x),
      .weights = basis.weights(dx, n)};
  const ContactState state = solve_active_set(equations, load);
  return {.x = x,
          .bound = equations.bound,
          .traction = state.traction,
          .slip = state.slip,
          .displacement = influence_matrix(kernel, basis, dx, n) * state.traction,
          .zones = state.zones,
          .force = equations.weights.dot(state.traction),
          .creepage = state.creepage,
          .dissipation = -equations.weights.cwiseProduct(state.traction).dot(state.slip),
          .iterations = state.iterations};
}

}  // namespace microslip
