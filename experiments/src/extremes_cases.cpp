// SPDX-License-Identifier: GPL-3.0-or-later
#include "extremes_cases.hpp"

namespace microslip::experiments::extremes_study {

namespace {

std::string verdict_on(const Attempt& attempt, const Finding& found,
                       const ExtremesParameters::Limits& limits) {
  if (attempt.status != Status::ok) return name_of(attempt.status);
  if (!(found.error <= limits.error)) return "inaccurate";
  return found.wiggle > limits.wiggle ? "wiggles" : "ok";
}

}  // namespace

Finding finding_of(const SteadySolution& found, double error) {
  return {.error = error,
          .condition = found.condition,
          .evidence = found.evidence,
          .iterations = static_cast<double>(found.iterations)};
}

double creepage_by_elements(SteadyProblem problem, Eigen::Index elements) {
  problem.grid = problem.grid.with_elements(elements);
  problem.method = Calibrated{};
  return solve_steady(problem).creepage;
}

Outcome outcome_of(Runs& smaller, const Case& at, const ExtremesParameters::Limits& limits) {
  Finding found;
  const Attempt attempt = smaller.run(at.size, [&] { found = at.solve(); });
  return {.at = at,
          .finding = found,
          .verdict = verdict_on(attempt, found, limits),
          .message = attempt.message};
}

Table table_of(const Map& map, const std::vector<Outcome>& outcomes) {
  std::vector<Column> columns{{"scheme", "1", "how the case is solved"}};
  columns.insert(columns.end(), map.coordinates.begin(), map.coordinates.end());
  columns.insert(
      columns.end(),
      {{"verdict", "1",
        "ok; wiggles or inaccurate, above the limits; refused as bad input; no_solution; not_run, "
        "as it would take too long"},
       {"error", "1", "of what is not prescribed, force or creepage; relative", map.rounding},
       {"wiggle", "1",
        "amplitude of the error where it alternates over four nodes or more, over the peak of the "
        "bound"},
       {"condition", "1", "of the equations in adhesion, estimate"},
       {"residual", "1", "backward error: slip left in adhesion over the largest term", 1e-12},
       {"violation", "1",
        "larger of the force above the bound over the load, and of the power gained by slip over "
        "the power lost",
        1e-12},
       {"iterations", "1", "partitions tried, or systems solved; largest of all steps"},
       {"message", "1", "why there is no result"}});
  Table table(map.name, map.description, columns);
  for (const Outcome& outcome : outcomes) {
    std::vector<Cell> row{outcome.at.scheme};
    for (const double coordinate : outcome.at.place) row.emplace_back(coordinate);
    const bool has_result = outcome.message.empty() && outcome.verdict != "not_run";
    const Finding& found = outcome.finding;
    const Evidence& evidence = found.evidence;
    const auto of_result = [&](double value) { return has_result ? value : not_given; };
    row.insert(row.end(), {outcome.verdict, found.error, found.wiggle, found.condition,
                           of_result(evidence.residual), of_result(evidence.violation()),
                           found.iterations, outcome.message.empty() ? "-" : outcome.message});
    table.add(row);
  }
  return table;
}

}  // namespace microslip::experiments::extremes_study
