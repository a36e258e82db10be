// SPDX-License-Identifier: GPL-3.0-or-later
#include "steady_elements.hpp"

#include <algorithm>
#include <cmath>

#include "../friction/slip_friction_search.hpp"
#include "element_solution.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/edge_calibration.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// -du/dx of the tractions, the last row of which may have been replaced.
LinearOperator strain_of(const SteadyProblem& problem, const Differences& differences) {
  const Kernel& kernel = problem.contact.kernel;
  const Grid& grid = problem.grid;
  const Basis& basis = problem.basis;
  const Solver& solver = problem.solver;
  const Index n = grid.size();
  const double dx = grid.spacing();
  if (!differences.edge_displacement) {
    return strain_operator(kernel, basis, dx, n, differences.step_ratio, solver);
  }
  if (solver.type == Solver::Type::fft) {
    reject("solver", "fft", "auto or dense where the displacement at the leading edge is known");
  }
  require_dense(n);
  Eigen::MatrixXd strain =
      influence_difference_matrix(kernel, basis, dx, n, differences.step_ratio) /
      (differences.step_ratio * dx);
  const double to_edge = grid.leading_offset() * dx;
  require(to_edge > 0, "leading_offset", grid.leading_offset(),
          "a number > 0 where the displacement at the leading edge is known");
  for (Index j = 0; j < n; ++j) {
    const ShapeFunction& shape = basis.shapes()[basis.shape_of(j, n)];
    strain(n - 1, j) = influence(kernel, shape, dx, static_cast<double>(n - 1 - j)) / to_edge;
  }
  return strain;
}

VectorXd lengths_of(const SteadyProblem& problem) {
  return problem.basis.weights(problem.grid.spacing(), problem.grid.size());
}

VectorXd mean_bound_of(const SteadyProblem& problem) {
  return element_means(problem.contact.bound, problem.grid.nodes(), lengths_of(problem));
}

/// Returns the bound that limits the tractions.
VectorXd bound_of(const SteadyProblem& problem, const Differences& differences) {
  return differences.mean_bounds ? mean_bound_of(problem)
                                 : bound_at(problem.contact.bound, problem.grid.nodes());
}

/// Returns the bound that is proportional to the pressure: at the nodes, as in CONTACT, or its mean
/// over the steps of the difference.
VectorXd pressed_bound_of(const SteadyProblem& problem, const Differences& differences) {
  const VectorXd x = problem.grid.nodes();
  if (!differences.mean_bounds) return bound_at(problem.contact.bound, x);
  const double reach = differences.step_ratio * problem.grid.spacing();
  VectorXd means =
      mean_bound_around(problem.contact.bound, (x.array() + reach / 2).matrix(), reach);
  if (problem.basis.has_only(constant_shape())) means[x.size() - 1] *= pressure_seen_at_edge;
  return means;
}

ActiveSet active_set_of(const SteadyProblem& problem, const Differences& differences) {
  return {strain_of(problem, differences), lengths_of(problem), problem.solver};
}

ContactState contact_by(ActiveSet& active_set, const SteadyProblem& problem,
                        const Differences& differences);

std::vector<Zone> zones_of(const SteadyProblem& problem, const Differences& differences) {
  ActiveSet active_set = active_set_of(problem, differences);
  return contact_by(active_set, problem, differences).zones;
}

/// Chooses the first partition. It is the one of a grid of fewer elements, so that the number of
/// rounds does not grow with the number of elements; on a coarse grid, adhesion everywhere. For a
/// step shorter than an element it is the partition of a whole step, which differs by few elements.
/// With a known displacement at the edge it is the partition without that displacement: tractions
/// next to the edge take the wrong sign, and there may be no way from adhesion. A coarser grid has to
/// resolve the waves of a kernel's table.
std::vector<Zone> first_zones(const SteadyProblem& problem, const Differences& differences) {
  constexpr Index ratio = 4;
  constexpr Index coarsest = 50;
  const Index n = problem.grid.size();
  if (differences.edge_displacement) {
    return zones_of(problem, Differences{.step_ratio = differences.step_ratio});
  }
  if (differences.step_ratio < 1) {
    Differences whole = differences;
    whole.step_ratio = 1;
    return zones_of(problem, whole);
  }
  const std::vector<Zone> adhesion(static_cast<std::size_t>(n), Zone::adhesion);
  if (n < ratio * coarsest) return adhesion;
  SteadyProblem coarse = problem;
  coarse.grid = problem.grid.with_elements(n / ratio);
  if (!resolves_waves(coarse.contact.kernel, coarse.grid.spacing())) return adhesion;
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

/// \return with the bound at rest
SlipConditions conditions_of(const SteadyProblem& problem, const Differences& differences) {
  const Grid& grid = problem.grid;
  const Index n = grid.size();
  SlipConditions conditions{.bound = bound_of(problem, differences),
                            .offset = VectorXd::Zero(n),
                            .reference = VectorXd::Zero(n)};
  if (problem.contact.has_unlike_bodies()) {
    conditions.offset = -problem.contact.pressure_strain * pressed_bound_of(problem, differences);
  }
  if (differences.edge_displacement) {
    conditions.offset[n - 1] =
        -*differences.edge_displacement / (grid.leading_offset() * grid.spacing());
  }
  return conditions;
}

ContactState contact_by(ActiveSet& active_set, const SteadyProblem& problem,
                        const Differences& differences) {
  return active_set.solve(conditions_of(problem, differences), problem.load,
                          first_zones(problem, differences));
}

/// Computes mu/mu_s at the nodes, along the material from the leading edge on. Between nodes, the
/// law's ratio is linear in the way slipped.
RatioOfSlip ratio_along(const SlipFriction& friction, const Grid& grid) {
  return [friction, &grid](const VectorXd& slip, VectorXd& ratio) {
    const Index last = slip.size() - 1;
    double before = 1;
    for (Index i = last; i >= 0; --i) {
      const double here = friction.speed * std::abs(slip[i]);
      if (friction.remembers()) {
        const double time =
            grid.spacing() * (i == last ? grid.leading_offset() : 1) / friction.speed;
        const double ahead = i == last ? here : friction.speed * std::abs(slip[i + 1]);
        before = friction.ratio_after(before, ahead, here, time);
      } else {
        before = friction.law(here);
      }
      ratio[i] = before;
    }
  };
}

/// The force of elements in adhesion at places where the bound is below their traction, as in gaps
/// of a contact that are shorter than elements. The outermost elements do not count: tractions
/// vanish there with the bound. Bounds other than tables have no such places  [N/mm]
double force_in_gaps(const SteadyProblem& problem, const ContactState& state) {
  constexpr int samples = 16;
  const auto* table = std::get_if<TabulatedBound>(&problem.contact.bound);
  if (table == nullptr) return 0;
  const VectorXd x = problem.grid.nodes();
  const double part = problem.grid.spacing() / samples;
  double force = 0;
  for (Index i = 1; i + 1 < x.size(); ++i) {
    if (state.zones[static_cast<std::size_t>(i)] != Zone::adhesion) continue;
    for (int k = 0; k < samples; ++k) {
      const double place = x[i] + (k + 0.5 - samples / 2.0) * part;
      force += part * std::max(0.0, std::abs(state.traction[i]) - (*table)(place));
    }
  }
  return force;
}

/// Computes Evidence::one_element. The end of a zone is known to a part of an element. Next to full
/// sliding, where the rest to full sliding is as small, this part decides on the creepage.
double one_element_zones(const ContactState& state, const VectorXd& lengths, const VectorXd& bound,
                         double force) {
  const auto& zones = state.zones;
  double within = 0, full_sliding = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const auto node = static_cast<Index>(i);
    const double most = lengths[node] * bound[node];
    const bool alone =
        (i == 0 || zones[i - 1] != zones[i]) && (i + 1 == zones.size() || zones[i + 1] != zones[i]);
    full_sliding += most;
    if (alone) within += most;
  }
  return within == 0 ? 0 : within / std::max(full_sliding - std::abs(force), within);
}

}  // namespace

SteadySolution by_differences(const SteadyProblem& problem, const Differences& differences) {
  const Grid& grid = problem.grid;
  const Index n = grid.size();
  const VectorXd x = grid.nodes();
  ActiveSet active_set = active_set_of(problem, differences);
  ContactState state;
  VectorXd bound = bound_of(problem, differences);
  VectorXd means = mean_bound_of(problem);
  bool has_second = false;
  if (problem.friction) {
    SlipFrictionSearch search(problem.friction->branch);
    SlipConditions conditions = conditions_of(problem, differences);
    state.zones = first_zones(problem, differences);
    search.solve(active_set, conditions, problem.load, ratio_along(*problem.friction, grid), state);
    bound = conditions.bound;
    means = means.cwiseProduct(search.ratio());
    has_second = search.has_second();
  } else {
    state = contact_by(active_set, problem, differences);
  }
  const VectorXd lengths = lengths_of(problem);
  SteadySolution solution =
      element_solution(problem, x, {lengths, bound, means, state.traction, state.slip}, state);
  solution.has_second = has_second;
  Evidence& evidence = solution.evidence;
  evidence.unresolved += force_in_gaps(problem, state);
  if (problem.contact.has_unlike_bodies()) {
    evidence.one_element = one_element_zones(state, lengths, bound, solution.force);
  }
  solution.displacement =
      influence_operator(problem.contact.kernel, problem.basis, grid.spacing(), n, problem.solver) *
      state.traction;
  solution.condition = active_set.condition();
  return solution;
}

}  // namespace microslip
