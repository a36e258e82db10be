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
#include "steady_elements.hpp"
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

SteadySolution on_calibrated_elements(const SteadyProblem& problem, const std::string& why) {
  require(problem.grid.size() >= fewest_calibrated, "elements",
          static_cast<double>(problem.grid.size()), "at least 11, as " + why);
  return over_whole_contact(problem, why);
}

SteadySolution instead_of_inversion(const SteadyProblem& problem, const std::string& why) {
  if (std::holds_alternative<TabulatedBound>(problem.contact.bound)) {
    return solve_on_resolved_elements(problem, why);
  }
  return on_calibrated_elements(problem, why);
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

namespace {

void validate(const SlipFriction& friction, const Contact& contact, const SteadyMethod& method) {
  microslip::validate(friction);
  if (contact.has_unlike_bodies()) {
    throw std::invalid_argument("friction_law: expected none where bodies differ in material");
  }
  if (std::holds_alternative<ChebyshevCollocation>(method)) {
    reject("method", "chebyshev",
           "collocation, the method by elements, where friction depends on slip");
  }
}

}  // namespace

void validate(const SteadyProblem& problem) {
  validate(problem.contact);
  if (problem.friction) validate(*problem.friction, problem.contact, problem.method);
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
  if (problem.contact.has_unlike_bodies() || problem.friction) return std::nullopt;
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
  if (problem.friction) return on_calibrated_elements(problem, "friction depends on slip");
  return by_inversion(problem);
}

}  // namespace microslip
