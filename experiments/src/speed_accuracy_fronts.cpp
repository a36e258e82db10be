// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_accuracy_fronts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/rolling/schemes.hpp"

namespace microslip::experiments::speed_accuracy_study {

namespace {

/// Two errors differ by rounding only if both are below `rounding`, or their relative difference is
/// below `equal`.
constexpr double rounding = 1e-13;
constexpr double equal = 1e-6;

constexpr std::array accuracies = {1e-2, 1e-3, 1e-4, 1e-6, 1e-9};

/// A quantity of a problem, and the runs that have it, from cheap to dear. They are all such runs,
/// or the runs by elements, which need no smooth bound.
struct Contest {
  std::string problem;
  std::string among;
  std::size_t quantity;
  std::vector<const Run*> runs;

  double error(const Run& run) const { return run.judgement.errors.values[quantity]; }
};

bool by_elements(const Run& run) {
  const std::string& scheme = run.contestant.scheme;
  return std::ranges::none_of(steady_schemes(), [&](const SteadyEntry& entry) {
    return entry.name == scheme && !entry.by_elements;
  });
}

/// Selects the runs of a problem that succeeded and have the quantity.
Contest contest_of(const std::string& problem, std::size_t quantity, bool elements_only,
                   const Cost& cost, const std::vector<Run>& runs) {
  Contest contest{problem, elements_only ? "elements" : "all", quantity, {}};
  for (const Run& run : runs) {
    const bool takes_part = run.contestant.problem == problem && run.status == "ok" &&
                            !std::isnan(contest.error(run)) && (!elements_only || by_elements(run));
    if (takes_part) contest.runs.push_back(&run);
  }
  std::ranges::stable_sort(contest.runs, [&](const Run* first, const Run* second) {
    const double least = first->*cost.value;
    const double other = second->*cost.value;
    return least != other ? least < other : contest.error(*first) < contest.error(*second);
  });
  return contest;
}

std::vector<Contest> contests(const Cost& cost, const std::vector<Run>& runs) {
  std::vector<std::string> problems;
  for (const Run& run : runs) {
    const std::string& problem = run.contestant.problem;
    if (std::ranges::find(problems, problem) == problems.end()) problems.push_back(problem);
  }
  std::vector<Contest> all;
  for (const std::string& problem : problems) {
    for (std::size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
      const Contest contest = contest_of(problem, quantity, false, cost, runs);
      if (contest.runs.empty()) continue;
      all.push_back(contest);
      const Contest elements = contest_of(problem, quantity, true, cost, runs);
      if (elements.runs.size() < contest.runs.size()) all.push_back(elements);
    }
  }
  return all;
}

std::vector<Cell> joined(std::vector<Cell> cells, std::initializer_list<Cell> more) {
  cells.insert(cells.end(), more);
  return cells;
}

std::vector<Column> columns_of(const Cost& cost, const std::vector<Column>& first) {
  std::vector<Column> columns{{"problem", "1", "plane, strip, transient or cylinder"},
                              {"quantity", "1", "of which the error is"},
                              {"among", "1", "all, or elements: without chebyshev and inversion"}};
  columns.insert(columns.end(), first.begin(), first.end());
  const std::vector<Column> who = contestant_columns();
  columns.insert(columns.end(), who.begin() + 1, who.end());
  columns.insert(columns.end(),
                 {{"elements", "1", "N; unknowns of chebyshev; nodes shown of inversion"},
                  {"error", "1", "relative"},
                  {cost.name, cost.unit, cost.meaning}});
  return columns;
}

std::vector<Cell> cells_of(const Contest& contest, const Cost& cost, const Run& run) {
  std::vector<Cell> cells = contestant_cells(run.contestant);
  cells.erase(cells.begin());
  return joined(cells, {static_cast<double>(run.elements), contest.error(run), run.*cost.value});
}

void append(std::vector<Cell>& row, const std::vector<Cell>& cells) {
  row.insert(row.end(), cells.begin(), cells.end());
}

}  // namespace

std::vector<Column> contestant_columns() {
  return {
      {"problem", "1", "plane, strip, transient or cylinder"},
      {"scheme", "1", "collocation, chebyshev or inversion; step.scheme; with the integrator"},
      {"edge", "1", "leading_edge; aligned: standard, with the edges where the scheme feels them"},
      {"basis", "1", "constant, linear, quadratic, or linear with the last one trimmed"},
      {"step_ratio", "1", "c = dq/dx; nan where it has no role"},
      {"solver", "1", "dense or fft"}};
}

std::vector<Cell> contestant_cells(const Contestant& c) {
  return {c.problem, c.scheme, c.edge, c.basis, c.step_ratio, c.solver};
}

Table fronts_table(const std::string& name, const Cost& cost, const std::vector<Run>& runs) {
  Table table(name, "runs that no other beats both in error and in " + cost.name,
              columns_of(cost, {}));
  for (const Contest& contest : contests(cost, runs)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Run* run : contest.runs) {
      const double error = std::max(contest.error(*run), rounding);
      if (!(error < (1 - equal) * least)) continue;
      least = error;
      std::vector<Cell> row{contest.problem, quantity_names[contest.quantity], contest.among};
      append(row, cells_of(contest, cost, *run));
      table.add(row);
    }
  }
  return table;
}

Table cheapest_table(const std::string& name, const Cost& cost, const std::vector<Run>& runs) {
  Table table(name, fmt::format("the least {} for an accuracy", cost.name),
              columns_of(cost, {{"accuracy", "1", "that the error must not exceed"}}));
  for (const Contest& contest : contests(cost, runs)) {
    for (const double accuracy : accuracies) {
      const auto found = std::ranges::find_if(
          contest.runs, [&](const Run* run) { return contest.error(*run) <= accuracy; });
      std::vector<Cell> row{contest.problem, quantity_names[contest.quantity], contest.among,
                            accuracy};
      if (found == contest.runs.end()) {
        append(row, {"none", "none", "none", not_given, "none", not_given, not_given, not_given});
      } else {
        append(row, cells_of(contest, cost, **found));
      }
      table.add(row);
    }
  }
  return table;
}

}  // namespace microslip::experiments::speed_accuracy_study
