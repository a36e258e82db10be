// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/steady.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "brush_rolling.hpp"
#include "element_solution.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/edge_calibration.hpp"
#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "resolved_elements.hpp"
#include "unlike_rolling.hpp"
#include "zoned_rolling.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

Index SteadySolution::adhesion_elements() const {
  return std::count(zones.begin(), zones.end(), Zone::adhesion);
}

Index SteadySolution::slip_elements() const { return x.size() - adhesion_elements(); }

namespace {

/// -du/dx of the tractions, the last row of which may have been replaced.
LinearOperator strain_of(const SteadyProblem& problem, const Differences& differences) {
  const auto& [contact, grid, basis, method, load, solver, accepted] = problem;
  const Kernel& kernel = contact.kernel;
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

ContactState contact_by(ActiveSet& active_set, const SteadyProblem& problem,
                        const Differences& differences) {
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
  return active_set.solve(conditions, problem.load, first_zones(problem, differences));
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

SteadySolution by_differences(const SteadyProblem& problem, const Differences& differences) {
  const Grid& grid = problem.grid;
  const Index n = grid.size();
  const VectorXd x = grid.nodes();
  ActiveSet active_set = active_set_of(problem, differences);
  const ContactState state = contact_by(active_set, problem, differences);
  const VectorXd bound = bound_of(problem, differences);
  const VectorXd lengths = lengths_of(problem);
  SteadySolution solution = element_solution(
      problem, x, {lengths, bound, mean_bound_of(problem), state.traction, state.slip}, state);
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

/// \param solution  as functions of x, with one stick zone
template <class Solution>
SteadySolution sampled(const SteadyProblem& problem, const Solution& solution,
                       SteadyScheme scheme) {
  const VectorXd x = problem.grid.nodes();
  SteadySolution state{.x = x,
                       .bound = bound_at(problem.contact.bound, x),
                       .traction = x.unaryExpr([&](double xi) { return solution.traction(xi); }),
                       .slip = x.unaryExpr([&](double xi) { return solution.slip(xi); }),
                       .displacement = solution.displacement(x),
                       .zones = {},
                       .force = solution.force(),
                       .creepage = solution.creepage(),
                       .dissipation = solution.dissipation(),
                       .iterations = solution.evaluations(),
                       .evidence = solution.evidence(),
                       .condition = solution.condition(),
                       .stick_edge = solution.stick_edge(),
                       .scheme = scheme};
  const Zone slipping = solution.creepage() < 0 ? Zone::slip_positive : Zone::slip_negative;
  for (const double xi : x) state.zones.push_back(solution.sticks(xi) ? Zone::adhesion : slipping);
  return state;
}

SteadySolution over_whole_contact(const SteadyProblem& problem, const std::string& why) {
  const SteadyProblem whole = whole_contact(problem);
  SteadySolution solution = by_differences(whole, std::get<Differences>(whole.method));
  solution.scheme = SteadyScheme::calibrated;
  solution.fallback = why;
  return solution;
}

/// Fewer elements may be wrong by more than a tenth: study extremes.
constexpr Index fewest_calibrated = 11;

SteadySolution instead_of_inversion(const SteadyProblem& problem, const std::string& why) {
  if (std::holds_alternative<TabulatedBound>(problem.contact.bound)) {
    return solve_on_resolved_elements(problem, why);
  }
  require(problem.grid.size() >= fewest_calibrated, "elements",
          static_cast<double>(problem.grid.size()), "at least 11, as " + why);
  return over_whole_contact(problem, why);
}

SteadySolution unlike_zones(const SteadyProblem& problem) {
  const std::string differ = "bodies differ in material";
  if (!std::holds_alternative<HertzBound>(problem.contact.bound)) {
    return instead_of_inversion(problem, differ + ", and the bound is not Hertz's");
  }
  std::string why = "finds no zones";
  try {
    if (auto found = unlike_by_inversion(problem)) return *found;
  } catch (const NotConverged& error) {
    why = fmt::format("does not converge ({})", error.what());
  }
  return instead_of_inversion(problem, fmt::format("{}, and the inversion {}", differ, why));
}

/// The inversion on one stick zone, which serves most bounds and costs least; none if the solution
/// has other zones.
std::optional<SteadySolution> on_one_zone(const SteadyProblem& problem) {
  const InvertedRolling rolling(problem.contact.kernel, problem.contact.bound);
  if (rolling.obstacle()) return std::nullopt;
  try {
    const InvertedSolution solution = rolling.solve(problem.load);
    if (!solution.keeps_conditions()) return std::nullopt;
    SteadySolution found = sampled(problem, solution, SteadyScheme::inversion);
    found.iterations = 0;
    return found;
  } catch (const NotConverged&) {
    return std::nullopt;  // no single stick zone carries the load
  }
}

SteadySolution by_inversion(const SteadyProblem& problem) {
  if (problem.contact.has_unlike_bodies()) return unlike_zones(problem);
  if (auto found = solve_by_inversion(problem)) return *found;
  if (!problem.contact.kernel.is_half_space()) {
    return instead_of_inversion(
        problem, fmt::format("the kernel is {}, not a half-space", problem.contact.kernel.name()));
  }
  const auto why = InvertedRolling(problem.contact.kernel, problem.contact.bound).obstacle();
  return instead_of_inversion(problem,
                              why.value_or("the inversion finds no zones of stick and slip"));
}

}  // namespace

std::string name_of(SteadyScheme scheme) {
  switch (scheme) {
    case SteadyScheme::inversion:
      return "inversion";
    case SteadyScheme::calibrated:
      return "calibrated";
    case SteadyScheme::chebyshev:
      return "chebyshev";
    case SteadyScheme::graded:
      return "graded elements";
    case SteadyScheme::closed_form:
      return "closed form";
    default:
      return "differences";
  }
}

SteadySolution element_solution(const SteadyProblem& problem, const VectorXd& x,
                                const ElementValues& values, const ContactState& contact) {
  const double force = values.lengths.dot(contact.traction);
  Evidence evidence = evidence_by_elements(values, force, contact.rigid_slip);
  evidence.residual = contact.residuals.equations;
  double dissipation = -contact.rigid_slip * force;
  if (problem.contact.has_unlike_bodies()) {
    evidence.load = values.lengths.dot(contact.traction.cwiseAbs());
    evidence.power = dissipation = evidence.dissipated;
  }
  return {.x = x,
          .bound = values.bound,
          .traction = contact.traction,
          .slip = contact.slip,
          .displacement = {},
          .zones = contact.zones,
          .force = force,
          .creepage = contact.rigid_slip,
          .dissipation = dissipation,
          .iterations = contact.iterations,
          .evidence = evidence,
          .condition = 1};
}

double answer_of(const Load& load, const SteadySolution& solution) {
  return Prescribed(load).by_force ? solution.creepage : solution.force;
}

double change_of_answer(const Load& load, const SteadySolution& coarse,
                        const SteadySolution& fine) {
  const double answer = answer_of(load, fine);
  const double change = std::abs(answer_of(load, coarse) - answer);
  return change == 0 ? 0 : change / std::abs(answer);
}

void validate(const SteadyProblem& problem) {
  validate(problem.contact);
  if (!problem.contact.has_unlike_bodies()) return;
  const auto* differences = std::get_if<Differences>(&problem.method);
  if (std::holds_alternative<ChebyshevCollocation>(problem.method)) {
    reject("method", "chebyshev", "collocation for bodies of different material");
  }
  if (differences != nullptr && differences->edge_displacement) {
    reject("leading_edge", "known_edge",
           "inversion, calibrated, standard or trimmed for bodies of different material");
  }
}

std::optional<SteadySolution> solve_by_inversion(const SteadyProblem& problem) {
  if (problem.contact.has_unlike_bodies()) return std::nullopt;
  if (!problem.contact.kernel.spreads()) return solve_brush(problem);
  if (!problem.contact.kernel.is_half_space()) return std::nullopt;
  if (auto found = on_one_zone(problem)) return found;
  return solve_by_zones(problem);
}

SteadyProblem whole_contact(const SteadyProblem& problem) {
  const Index n = problem.grid.size();
  const double a = problem.grid.half_width();
  const double soft = softness(problem.contact.kernel, 2 * a / static_cast<double>(n));
  const double offset =
      n < 2 ? 0.5 : std::clamp(calibrated_offset(problem.basis, n, soft, problem.solver), 0.5, 1.0);
  SteadyProblem whole = problem;
  whole.grid = Grid({.half_width = a,
                     .elements = n,
                     .leading_offset = offset,
                     .trailing_offset = n < 2 ? 0.5 : offset - 0.5});
  whole.method = Differences{.mean_bounds = true};
  return whole;
}

SteadySolution solve_steady(const SteadyProblem& problem) {
  validate(problem);
  if (const auto* differences = std::get_if<Differences>(&problem.method)) {
    return by_differences(problem, *differences);
  }
  if (std::holds_alternative<ChebyshevCollocation>(problem.method)) {
    const ChebyshevRolling rolling(problem.contact.kernel, problem.contact.bound);
    return sampled(problem, rolling.solve(problem.load), SteadyScheme::chebyshev);
  }
  if (std::holds_alternative<Calibrated>(problem.method)) return over_whole_contact(problem, "");
  return by_inversion(problem);
}

}  // namespace microslip
