// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/steady.hpp"

#include <algorithm>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

Eigen::Index SteadySolution::adhesion_elements() const {
  return std::count(zones.begin(), zones.end(), Zone::adhesion);
}

Eigen::Index SteadySolution::slip_elements() const { return x.size() - adhesion_elements(); }

SteadySolution solve_steady(const SteadyProblem& problem) {
  const auto& [kernel, bound, grid, basis, step_ratio, load, edge_displacement] = problem;
  const Eigen::Index n = grid.size();
  const double dx = grid.spacing();
  const Eigen::VectorXd x = grid.nodes();
  const Eigen::MatrixXd influence = influence_matrix(kernel, basis, dx, n);
  Eigen::MatrixXd strain =
      influence_difference_matrix(kernel, basis, dx, n, step_ratio) / (step_ratio * dx);
  SlipConditions conditions{.bound = bound_at(bound, x),
                            .offset = Eigen::VectorXd::Zero(n),
                            .reference = Eigen::VectorXd::Zero(n)};
  if (edge_displacement) {
    const double to_edge = grid.leading_offset() * dx;
    require(to_edge > 0, "grid.leading_offset", grid.leading_offset(),
            "a number > 0 where the displacement at the leading edge is known");
    strain.row(n - 1) = influence.row(n - 1) / to_edge;
    conditions.offset[n - 1] = -*edge_displacement / to_edge;
  }
  const Eigen::VectorXd weights = basis.weights(dx, n);
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

}  // namespace microslip
