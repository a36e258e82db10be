// SPDX-License-Identifier: GPL-3.0-or-later
#include "extremes_cases.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"
#include "speed_accuracy_runs.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

std::string verdict_on(const Finding& found, const ExtremesParameters::Limits& limits) {
  if (!(found.error <= limits.error)) return "inaccurate";
  return found.wiggle > limits.wiggle ? "wiggles" : "ok";
}

/// Continued from the same with fewer elements.
bool takes_too_long(const std::vector<Outcome>& before, const Case& at, double operations) {
  std::vector<double> sizes, work;
  for (std::size_t back = at.smaller, k = before.size(); back > 0; back = before[k].at.smaller) {
    k -= back;
    if (before[k].verdict == "not_run") return true;
    sizes.insert(sizes.begin(), before[k].at.size);
    work.insert(work.begin(), before[k].finding.work);
  }
  return !sizes.empty() && expected_work(sizes, work, at.size) > operations;
}

}  // namespace

double wiggle_of(const VectorXd& error) {
  constexpr Index wave = 4;
  const Index n = error.size();
  if (n < wave + 2) return 0;
  VectorXd bend = error.segment(1, n - 2) - (error.head(n - 2) + error.tail(n - 2)) / 2;
  for (Index i = 1; i < bend.size(); i += 2) bend[i] = -bend[i];
  double largest = 0;
  for (Index i = 0; i + wave <= bend.size(); ++i) {
    const auto part = bend.segment(i, wave);
    const double least = part[0] > 0 ? part.minCoeff() : -part.maxCoeff();
    largest = std::max(largest, least / 2);
  }
  return largest;
}

Outcome outcome_of(const std::vector<Outcome>& before, const Case& at,
                   const ExtremesParameters::Limits& limits) {
  Outcome outcome{.at = at, .finding = {}, .verdict = "not_run", .message = ""};
  if (takes_too_long(before, at, limits.operations)) return outcome;
  const WorkCount count;
  try {
    outcome.finding = at.solve();
    outcome.verdict = verdict_on(outcome.finding, limits);
  } catch (const NotConverged& error) {
    outcome.verdict = "no_solution";
    outcome.message = error.what();
  } catch (const std::invalid_argument& error) {
    outcome.verdict = "refused";
    outcome.message = error.what();
  }
  outcome.finding.work = count.operations();
  return outcome;
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

}  // namespace microslip::experiments
