// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip::experiments {

namespace {

/// Names the scheme that ran, and says why it is not the scheme asked for.
std::string method_of(const SteadySolution& solution) {
  return fmt::format("by {}{}", name_of(solution.scheme),
                     solution.fallback.empty() ? "" : ", because " + solution.fallback);
}

/// Warns if there is another solution, or if another scheme ran than asked for. Tables do not count, whose elements have evidence of
/// their own, nor other bounds than Hertz's for bodies of different material, nor friction that
/// depends on slip: elements are the regular way to solve them.
std::optional<std::string> doubt_of(const SteadySolution& solution, const SteadyProblem& problem) {
  if (solution.has_second) return second_solution(problem.friction->branch);
  const bool table = std::holds_alternative<TabulatedBound>(problem.contact.bound);
  const bool elements =
      problem.friction || (problem.contact.has_unlike_bodies() &&
                           !std::holds_alternative<HertzBound>(problem.contact.bound));
  if (solution.fallback.empty() || table || elements) return std::nullopt;
  return method_of(solution);
}

Table nodes(const SteadySolution& solution) {
  return traction_table("steady rolling, values at the nodes; " + method_of(solution),
                        {solution.x, solution.bound, solution.traction, solution.slip,
                         solution.displacement, solution.zones});
}

Table summary_of(const std::string& description, const SteadySolution& solution,
                 const SteadyProblem& problem, const std::optional<double>& error = std::nullopt) {
  const double full_sliding = full_sliding_force(problem.contact.bound);
  Table summary = empty_summary(fmt::format("{}; {}", description, method_of(solution)));
  summary.add({"force", solution.force, "N/mm"});
  summary.add({"creepage", solution.creepage, "1"});
  summary.add({"force_ratio", solution.force / full_sliding, "1"});
  summary.add({"full_sliding_force", full_sliding, "N/mm"});
  if (solution.stick_edge) summary.add({"stick_edge", *solution.stick_edge, "mm"});
  summary.add({"adhesion_elements", solution.adhesion_elements(), "1"});
  summary.add({"slip_elements", solution.slip_elements(), "1"});
  summary.add({"iterations", solution.iterations, "1"});
  summary.add({"dissipation", solution.dissipation, "N/mm"});
  if (problem.friction) summary.add({"second_solution", solution.has_second ? 1 : 0, "1"});
  summary.add({"method", name_of(solution.scheme), "1"});
  if (error) summary.add({"estimated_error", *error, "1"});
  add_evidence(summary, solution.evidence,
               {.condition = solution.condition,
                .iterations = solution.iterations,
                .accepted = problem.accepted,
                .steady = true,
                .doubt = doubt_of(solution, problem)});
  return summary;
}

/// The solution; on equal elements under a table with the change from elements twice as long, which
/// is about the error where a bound is steep.
SteadySolution solve_with_change(const SteadyProblem& problem) {
  constexpr Eigen::Index fewest = 8;
  SteadySolution solution = solve_steady(problem);
  const bool by_elements = problem.friction || std::holds_alternative<Calibrated>(problem.method) ||
                           std::holds_alternative<Differences>(problem.method);
  const Eigen::Index elements = problem.grid.size();
  if (!by_elements || elements < fewest ||
      !std::holds_alternative<TabulatedBound>(problem.contact.bound)) {
    return solution;
  }
  SteadyProblem coarse = problem;
  coarse.grid = problem.grid.with_elements(elements / 2);
  try {
    solution.evidence.change = change_of_answer(problem.load, solve_steady(coarse), solution);
  } catch (const NotConverged&) {
    solution.evidence.change = 1;
  }
  return solution;
}

}  // namespace

std::vector<Table> scene_tables(const SteadyProblem& problem, const Progress& progress) {
  constexpr std::size_t percent = 100;
  const double one = work_needed(problem) / percent;
  const SteadySolution solution = [&] {
    const WorkWatch watch([&](double done) {
      progress(std::min(percent - 1, static_cast<std::size_t>(done / one)), percent);
    });
    return solve_with_change(problem);
  }();
  progress(percent, percent);
  return {nodes(solution), summary_of("steady rolling, the whole contact", solution, problem)};
}

std::vector<Table> scene_tables(const SteadyTarget& target, const Progress& progress) {
  constexpr double unit = 1e8;  // operations that progress counts as one
  const EstimatedSteady found = [&] {
    const WorkWatch watch(
        [&](double done) { progress(static_cast<std::size_t>(done / unit), unknown_total); });
    return solve_steady_to(target.contact, target.error);
  }();
  const std::string picked =
      found.solution.scheme == SteadyScheme::inversion
          ? "leading_edge inversion"
          : fmt::format("leading_edge calibrated, basis constant, grid.elements {}",
                        found.unknowns);
  Table summary = summary_of("steady rolling, the whole contact; picked: " + picked, found.solution,
                             found.problem, found.error);
  summary.add({"unknowns", found.unknowns, "1"});
  return {nodes(found.solution), summary};
}

}  // namespace microslip::experiments
