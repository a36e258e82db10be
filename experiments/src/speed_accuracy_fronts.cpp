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
/// or the runs by elements, which need no smooth bound, or the runs of one scheme.
struct Contest {
  std::string problem;
  std::string among;  ///< all, elements or a scheme
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

bool is_among(const Run& run, const std::string& among) {
  if (among == "all") return true;
  return among == "elements" ? by_elements(run) : run.contestant.family() == among;
}

/// Selects the runs of a problem that succeeded and have the quantity.
Contest contest_of(const std::string& problem, std::size_t quantity, const std::string& among,
                   const Cost& cost, const std::vector<Run>& runs) {
  Contest contest{problem, among, quantity, {}};
  for (const Run& run : runs) {
    const bool takes_part = run.contestant.problem == problem && run.status == "ok" &&
                            !std::isnan(contest.error(run)) && is_among(run, among);
    if (takes_part) contest.runs.push_back(&run);
  }
  std::ranges::stable_sort(contest.runs, [&](const Run* first, const Run* second) {
    const double least = first->*cost.value;
    const double other = second->*cost.value;
    return least != other ? least < other : contest.error(*first) < contest.error(*second);
  });
  return contest;
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

/// Lists the contests of a problem: among all, among elements if these are fewer, and among the
/// runs of each scheme.
void add_contests(const std::string& problem, const Cost& cost, const std::vector<Run>& runs,
                  std::vector<Contest>& all) {
  std::vector<std::string> schemes;
  for (const Run& run : runs) {
    if (run.contestant.problem == problem) add_once(schemes, run.contestant.family());
  }
  for (std::size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
    const Contest contest = contest_of(problem, quantity, "all", cost, runs);
    if (contest.runs.empty()) continue;
    all.push_back(contest);
    const Contest elements = contest_of(problem, quantity, "elements", cost, runs);
    if (elements.runs.size() < contest.runs.size()) all.push_back(elements);
    for (const std::string& scheme : schemes) {
      all.push_back(contest_of(problem, quantity, scheme, cost, runs));
    }
  }
}

std::vector<Contest> contests(const Cost& cost, const std::vector<Run>& runs) {
  std::vector<std::string> problems;
  for (const Run& run : runs) add_once(problems, run.contestant.problem);
  std::vector<Contest> all;
  for (const std::string& problem : problems) add_contests(problem, cost, runs, all);
  return all;
}

/// Returns the cheapest run within the accuracy, or null.
const Run* cheapest(const Contest& contest, double accuracy, bool of_thesis) {
  const auto found = std::ranges::find_if(contest.runs, [&](const Run* run) {
    return contest.error(*run) <= accuracy && (!of_thesis || run->contestant.of_thesis());
  });
  return found == contest.runs.end() ? nullptr : *found;
}

std::vector<Cell> joined(std::vector<Cell> cells, std::initializer_list<Cell> more) {
  cells.insert(cells.end(), more);
  return cells;
}

std::vector<Column> columns_of(const Cost& cost, const std::vector<Column>& first) {
  std::vector<Column> columns{{"problem", "1", "plane, strip, transient, creepage or cylinder"},
                              {"quantity", "1", "of which the error is"},
                              {"among", "1",
                               "all; elements: without chebyshev and inversion; or one scheme, of "
                               "any basis, c and solver"}};
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
      {"problem", "1", "plane, strip, transient, creepage or cylinder"},
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
  std::vector<Column> columns =
      columns_of(cost, {{"accuracy", "1", "that the error must not exceed"}});
  columns.insert(columns.end(),
                 {{"thesis_scheme", "1", "of the thesis, that reaches the accuracy at least cost"},
                  {"thesis_elements", "1", "its N"},
                  {"thesis_" + cost.name, cost.unit, "its cost"},
                  {"gain", "1", "its cost over the least"}});
  Table table(name, fmt::format("the least {} for an accuracy, beside the thesis's", cost.name),
              columns);
  for (const Contest& contest : contests(cost, runs)) {
    if (contest.among != "all" && contest.among != "elements") continue;
    for (const double accuracy : accuracies) {
      const Run* found = cheapest(contest, accuracy, false);
      const Run* thesis = cheapest(contest, accuracy, true);
      std::vector<Cell> row{contest.problem, quantity_names[contest.quantity], contest.among,
                            accuracy};
      if (found) {
        append(row, cells_of(contest, cost, *found));
      } else {
        append(row, {"none", "none", "none", not_given, "none", not_given, not_given, not_given});
      }
      if (thesis) {
        append(row, {thesis->contestant.family(), static_cast<double>(thesis->elements),
                     thesis->*cost.value, thesis->*cost.value / (found->*cost.value)});
      } else {
        append(row, {"none", not_given, not_given, not_given});
      }
      table.add(row);
    }
  }
  return table;
}

}  // namespace microslip::experiments::speed_accuracy_study
