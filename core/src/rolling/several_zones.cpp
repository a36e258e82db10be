// SPDX-License-Identifier: GPL-3.0-or-later
#include "several_zones.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/friction/full_sliding.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/calibrated_rolling.hpp"
#include "microslip/support/interpolation.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// n nodes, the last of which is `leading` elements from the leading edge and the first half an
/// element from the trailing one.
struct Lattice {
  Lattice(double half_width, double leading, Index n)
      : spacing(2 * half_width / (static_cast<double>(n) - 0.5 + leading)),
        x(VectorXd::LinSpaced(n, -half_width + spacing / 2, half_width - leading * spacing)) {}

  double spacing;
  VectorXd x;
};

}  // namespace

SteadySolution with_several_zones(const SteadyProblem& problem) {
  const Index n = problem.grid.size();
  const Lattice lattice(problem.grid.half_width(),
                        edge_calibration(problem.basis, n, problem.solver).offset, n);
  const double h = lattice.spacing;
  const FullSliding sliding(problem.kernel, problem.bound);
  const auto* force = std::get_if<PrescribedForce>(&problem.load);
  const double value = force ? force->value : std::get<PrescribedCreepage>(problem.load).value;
  const double direction = (force ? -value : value) < 0 ? -1 : 1;
  // Full sliding is exact, in its strain and its force; elements make the difference to it.
  const VectorXd bound = bound_at(problem.bound, lattice.x);
  const VectorXd weights = problem.basis.weights(h, n);
  const SlipConditions conditions{.bound = bound,
                                  .offset = lattice.x.unaryExpr([&](double x) {
                                    return -direction * sliding.strain(x + h / 2);
                                  }),
                                  .reference = -direction * bound};
  const double exact_less_elements = -direction * (sliding.force() - weights.dot(bound));
  const Load load = force ? Load(PrescribedForce{value - exact_less_elements}) : problem.load;
  ActiveSet active_set(strain_operator(problem.kernel, problem.basis, h, n, 1, problem.solver),
                       weights, problem.solver);
  const ContactState contact = active_set.solve(conditions, load);
  const VectorXd difference = contact.traction - conditions.reference;
  const VectorXd displacement =
      influence_operator(problem.kernel, problem.basis, h, n, problem.solver) * difference -
      direction * lattice.x.unaryExpr([&](double x) { return sliding.displacement(x); });

  const VectorXd x = problem.grid.nodes();
  const VectorXd bound_at_nodes = bound_at(problem.bound, x);
  const auto at_nodes = [&](const VectorXd& values) { return interpolated(lattice.x, values, x); };
  SteadySolution state{.x = x,
                       .bound = bound_at_nodes,
                       .traction = at_nodes(difference) - direction * bound_at_nodes,
                       .slip = at_nodes(contact.slip),
                       .displacement = at_nodes(displacement),
                       .zones = {},
                       .force = weights.dot(contact.traction) + exact_less_elements,
                       .creepage = contact.creepage,
                       .dissipation = 0,
                       .iterations = contact.iterations,
                       .evidence = contact.evidence,
                       .condition = active_set.condition()};
  state.dissipation = -state.creepage * state.force;
  for (const double xi : x) {
    const double place = std::round((xi - lattice.x[0]) / h);
    const double nearest = std::clamp(place, 0.0, static_cast<double>(n - 1));
    state.zones.push_back(contact.zones[static_cast<std::size_t>(nearest)]);
  }
  return state;
}

}  // namespace microslip
