// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/target_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;

SteadyProblem problem_of(const SteadyContact& contact, Index elements, const SteadyMethod& method) {
  return {.contact = contact,
          .grid = Grid({.half_width = half_width_of(contact.bound), .elements = elements}),
          .basis = constant_basis(),
          .method = method,
          .load = contact.load};
}

namespace {

/// Number of nodes in tables if the solution does not depend on the grid.
constexpr Index shown_nodes = 100;

constexpr Index fewest_elements = 16;
/// More elements would take minutes.
constexpr Index most_elements = 1 << 16;
/// A target that second order would reach by this many times more is not tried for.
constexpr double hopeless = 4;

SteadyProblem by_elements(const SteadyContact& contact, Index elements) {
  return problem_of(contact, elements, Calibrated{});
}

double relative(double difference, double value) {
  return difference == 0 ? 0 : std::abs(difference / value);
}

/// Relative change of the result over the relative change of the load, by the scheme that works for
/// any contact.
double sensitivity(const SteadyContact& contact) {
  constexpr double change = 1e-2;
  constexpr Index elements = 64;
  SteadyProblem problem = by_elements(contact, elements);
  const double value = answer_of(contact.load, solve_steady(problem));
  std::visit([](auto& load) { load.value *= 1 - change; }, problem.load);
  return relative(answer_of(contact.load, solve_steady(problem)) - value, value) / change;
}

/// Error of the result that violations of the contact conditions may cause. A violation is a share
/// of the force: under a prescribed force it acts like a change of the load, under a prescribed
/// creepage it is the error.
double cost_of(const Evidence& evidence, const SteadyContact& contact) {
  const double violation = evidence.violation();
  if (violation <= std::numeric_limits<double>::epsilon()) return violation;
  const bool by_force = Prescribed(contact.load).by_force;
  return violation * (by_force ? std::max(1.0, sensitivity(contact)) : 1);
}

/// The change of the answer by the inversion on one stick zone with finer quadratures; none if
/// there are several zones.
std::optional<double> change_by_fineness(const SteadyContact& contact, double found,
                                         Index& unknowns) {
  constexpr double finer = 1.5;
  try {
    const InvertedSolution other =
        InvertedRolling(contact.kernel, contact.bound, finer).solve(contact.load);
    if (!other.keeps_conditions()) return std::nullopt;
    const bool by_force = Prescribed(contact.load).by_force;
    unknowns = other.unknowns();
    return relative((by_force ? other.creepage() : other.force()) - found, found);
  } catch (const NotConverged&) {
    return std::nullopt;
  }
}

/// The solution by inversion, or the closed form of a brush; none if elements replace it.
std::optional<EstimatedSteady> by_inversion(const SteadyContact& contact) {
  constexpr double rounding = 1e-13;
  constexpr double of_zones = 1e-8;  // tests/property/stick_zones_test.cpp
  constexpr double of_brush = 1e-11;
  const SteadyProblem problem = problem_of(contact, shown_nodes, Inversion{});
  const std::optional<SteadySolution> found = solve_by_inversion(problem);
  if (!found) return std::nullopt;
  const SteadySolution& solution = *found;
  const double cost = cost_of(solution.evidence, contact);
  if (solution.scheme == SteadyScheme::closed_form) {
    return EstimatedSteady{problem, solution, 0, of_brush + cost};
  }
  Index unknowns = 0;
  const auto change = change_by_fineness(contact, answer_of(contact.load, solution), unknowns);
  const double error = change ? 2 * std::abs(*change) + rounding : of_zones;
  return EstimatedSteady{problem, solution, unknowns, error + cost};
}

}  // namespace

void require_target_error(double target) {
  require(target >= finest_target && target <= coarsest_target, "target_error", target,
          "a number in [1e-11, 0.1]");
}

EstimatedSteady solve_steady_to(const SteadyContact& contact, double target) {
  require_target_error(target);
  const std::optional<EstimatedSteady> found = by_inversion(contact);
  return found && found->error <= target ? *found : estimate_by_elements(contact, target);
}

namespace {

/// The number of elements to begin with: as many as a table has rows are likely to resolve the
/// table.
Index fewest_for(const TractionBound& bound) {
  const auto* table = std::get_if<TabulatedBound>(&bound);
  return table == nullptr ? fewest_elements
                          : 2 * std::clamp<Index>(table->x().size() / 2, 128, 2048);
}

/// The longest distance from an edge, up to `most`, over which the bound does not carry the
/// traction of adhesion; found by bisection.
template <class Carries>
double longest_without(const Carries& carries, double most, double half_width) {
  const double shortest = 1e-12 * half_width;
  double length = most;
  while (length > shortest && carries(length)) length /= 2;
  return length;
}

/// Upper limit of the change of force over creepage due to a trailing slip zone shorter than a few
/// elements: a quarter of the zone's length over the half-width, as in Carter's solution. The zone
/// ends where the bound carries the load that adhesion would carry behind that point. For a
/// traction that is singular at the edge this load is (2/pi) sqrt(2 d/a) of the whole load at the
/// distance d; twice as much is taken here.
double cost_of_unresolved_slip(const SteadyContact& contact, const SteadySolution& solution) {
  constexpr Index resolved = 4;
  const auto sticks = std::find(solution.zones.begin(), solution.zones.end(), Zone::adhesion);
  const Index slipping = sticks - solution.zones.begin();
  if (slipping >= resolved) return 0;
  const double a = half_width_of(contact.bound);
  const double element = 2 * a / static_cast<double>(solution.x.size());
  const auto carries = [&](double distance) {
    const double bound =
        std::visit([&](const auto& g) { return g.integral(distance - a); }, contact.bound);
    return bound >=
           2 * std::abs(solution.force) * 2 / std::numbers::pi * std::sqrt(2 * distance / a);
  };
  return 2 * longest_without(carries, static_cast<double>(slipping + 1) * element, a) / (4 * a);
}

/// If the bound falls to the leading edge faster than a square root, bodies slip there, too, and an
/// element may be too long to resolve the leading slip zone. The resulting change was 0.1 to 0.3
/// times the length of that zone over the length of the stick zone:
/// tests/property/generated_contacts.hpp. The zone ends where the bound carries the traction of
/// adhesion, which is taken as the square root through the third node from the edge.
double cost_of_unresolved_leading_slip(const SteadyContact& contact,
                                       const SteadySolution& solution) {
  constexpr double share = 0.3;
  constexpr Index node = 3;
  const Index n = solution.x.size();
  const auto slips = std::find_if(solution.zones.rbegin(), solution.zones.rend(),
                                  [](Zone zone) { return zone != Zone::adhesion; });
  const Index sticking = slips - solution.zones.rbegin();
  if (sticking < node) return 0;
  const double a = half_width_of(contact.bound);
  const double element = 2 * a / static_cast<double>(n);
  const double factor = std::abs(solution.traction[n - node]) / std::sqrt(a - solution.x[n - node]);
  const auto carries = [&](double distance) {
    const double behind =
        std::visit([&](const auto& g) { return g.integral(a - distance); }, contact.bound);
    return full_sliding_force(contact.bound) - behind >=
           2. / 3 * factor * distance * std::sqrt(distance);
  };
  return share * longest_without(carries, 4 * element, a) /
         (static_cast<double>(sticking) * element);
}

/// Upper limit of the change of force over creepage if a stick zone begins at a jump of the bound,
/// which an element does not resolve: the traction is singular there, and force and creepage are
/// proportional to the length of the zone.
double cost_of_unresolved_jumps(const SteadySolution& solution) {
  constexpr double jump = 1.5;
  const auto sticks = [&](Index i) {
    return solution.zones[static_cast<std::size_t>(i)] == Zone::adhesion;
  };
  double cost = 0;
  for (Index i = 1; i < solution.x.size(); ++i) {
    if (!sticks(i) || sticks(i - 1) || solution.bound[i] < jump * solution.bound[i - 1]) continue;
    Index end = i;
    while (end < solution.x.size() && sticks(end)) ++end;
    cost = std::max(cost, 1 / static_cast<double>(end - i));
  }
  return cost;
}

/// Computes the estimate of the error, or a part of it that is above the target. The error depends
/// on the position of each kink within its element, so that the estimate is three times the largest
/// of several differences to solutions with fewer elements.
double error_of(const SteadyContact& contact, Index elements, const SteadySolution& fine,
                double target) {
  const double value = answer_of(contact.load, fine);
  const auto difference = [&](Index n) {
    return relative(value - answer_of(contact.load, solve_steady(by_elements(contact, n))), value);
  };
  const double cost = cost_of_unresolved_slip(contact, fine) +
                      cost_of_unresolved_leading_slip(contact, fine) +
                      cost_of_unresolved_jumps(fine) + 2 * std::numeric_limits<double>::epsilon() +
                      cost_of(fine.evidence, contact);
  double largest = difference(elements / 4) / 2;
  for (const Index fourteenths : {7, 8, 10, 12}) {
    if (cost + 3 * largest > target) break;
    largest = std::max(largest, difference(elements * fourteenths / 14));
  }
  return cost + 3 * largest;
}

}  // namespace

EstimatedSteady estimate_by_elements(const SteadyContact& contact, double target) {
  require_target_error(target);
  Index elements = fewest_for(contact.bound);
  for (;;) {
    const SteadyProblem problem = by_elements(contact, elements);
    const SteadySolution fine = solve_steady(problem);
    const double error = error_of(contact, elements, fine, target);
    if (error <= target) return {problem, fine, elements, error};
    const double wanted = 1.1 * static_cast<double>(elements) * std::sqrt(error / target);
    if (elements >= most_elements || wanted > hopeless * most_elements) {
      throw NotConverged(
          fmt::format("target_error = {} takes more than the {} elements that are tried at most; "
                      "the error of {} may be {} or more",
                      format_short(target), most_elements, elements,
                      format_apart(error, target).first),
          0, error);
    }
    const Index most = std::min(most_elements, 16 * elements);
    elements = std::clamp(2 * static_cast<Index>(std::ceil(wanted / 2)), 2 * elements, most);
  }
}

}  // namespace microslip
