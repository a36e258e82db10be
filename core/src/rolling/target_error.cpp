// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/target_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;

namespace {

/// Nodes of tables where the grid has no part in the solution.
constexpr Index shown_nodes = 100;

constexpr Index fewest_elements = 16;
constexpr Index most_elements = 1 << 20;

SteadyProblem problem_of(const SteadyContact& contact, Index elements, const SteadyMethod& method) {
  return {.kernel = contact.kernel,
          .bound = contact.bound,
          .grid = Grid({.half_width = half_width_of(contact.bound), .elements = elements}),
          .basis = constant_basis(),
          .method = method,
          .load = contact.load};
}

/// What is not prescribed.
double answer(const Load& load, const ChebyshevSolution& solution) {
  return std::holds_alternative<PrescribedForce>(load) ? solution.creepage() : solution.force();
}

double answer(const Load& load, const SteadySolution& solution) {
  return std::holds_alternative<PrescribedForce>(load) ? solution.creepage : solution.force;
}

double relative(double difference, double value) {
  return difference == 0 ? 0 : std::abs(difference / value);
}

/// Rounding is estimated from what other numbers of unknowns make of it, and so is truncation.
double chebyshev_error(const SteadyContact& contact, Index unknowns, double found) {
  const auto value = [&](Index n) {
    return answer(contact.load,
                  ChebyshevRolling(contact.kernel, contact.bound, n).solve(contact.load));
  };
  double largest = 0;
  for (const Index more : {3, 6, 9}) {
    largest = std::max(largest, std::abs(value(unknowns + more) - found));
  }
  return relative(2 * largest, found) + 2 * std::numeric_limits<double>::epsilon();
}

/// None where Chebyshev collocation is refused.
std::optional<EstimatedSteady> by_chebyshev(const SteadyContact& contact) {
  constexpr Index most_compared = 55;  // with 9 more
  try {
    const Index unknowns = ChebyshevRolling(contact.kernel, contact.bound).unknowns();
    if (unknowns > most_compared) return std::nullopt;
    const SteadyProblem problem = problem_of(contact, shown_nodes, ChebyshevCollocation{});
    const SteadySolution solution = solve_steady(problem);
    return EstimatedSteady{problem, solution, unknowns,
                           chebyshev_error(contact, unknowns, answer(contact.load, solution))};
  } catch (const NotConverged&) {
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

}  // namespace

void require_target_error(double target) {
  require(target >= finest_target && target <= coarsest_target, "target_error", target,
          "a number in [1e-11, 0.1]");
}

EstimatedSteady solve_steady_to(const SteadyContact& contact, double target) {
  require_target_error(target);
  std::optional<EstimatedSteady> found = by_chebyshev(contact);
  return found && found->error <= target ? *found : estimate_by_elements(contact, target);
}

EstimatedSteady estimate_by_elements(const SteadyContact& contact, double target) {
  require_target_error(target);
  Index elements = fewest_elements;
  for (;;) {
    const SteadyProblem problem = problem_of(contact, elements, Calibrated{});
    const SteadySolution coarse = solve_steady(problem_of(contact, elements / 2, Calibrated{}));
    const SteadySolution fine = solve_steady(problem);
    const double value = answer(contact.load, fine);
    const bool one_zone = fine.stick_edge && coarse.stick_edge;
    const double error =
        relative((one_zone ? 0.5 : 1) * (value - answer(contact.load, coarse)), value) +
        2 * std::numeric_limits<double>::epsilon();
    if (error <= target) return {problem, fine, elements, error};
    if (elements == most_elements) {
      throw NotConverged("target_error = " + format_short(target) + " with " +
                             std::to_string(elements) + " elements",
                         0, error);
    }
    const double wanted = 1.1 * static_cast<double>(elements) * std::sqrt(error / target);
    const Index most = std::min(most_elements, 16 * elements);
    elements = std::clamp(2 * static_cast<Index>(std::ceil(wanted / 2)), 2 * elements, most);
  }
}

}  // namespace microslip
