// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/contact_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace microslip::experiments {

std::string region(Zone zone) { return zone == Zone::adhesion ? "A" : "S"; }

Table traction_table(const std::string& description, const NodeValues& values) {
  Table table("traction", description,
              {{"x", "mm", "position; the leading edge is at x = +half_width"},
               {"bound", "N/mm^2", "traction bound g"},
               {"traction", "N/mm^2", "tangential traction p"},
               {"slip", "1", "relative slip s"},
               {"displacement", "mm", "tangential displacement difference u"},
               {"region", "1", "A adhesion, S slip"}});
  for (Eigen::Index i = 0; i < values.x.size(); ++i) {
    if (values.bound[i] <= 0 && values.traction[i] == 0) continue;
    table.add({values.x[i], values.bound[i], values.traction[i], values.slip[i],
               values.displacement[i], region(values.zones[static_cast<std::size_t>(i)])});
  }
  return table;
}

Table empty_summary(const std::string& description) {
  return {"summary",
          description,
          {{"quantity", "1", "name"},
           {"value", "see unit", "value"},
           {"unit", "1", "unit of the value"}}};
}

void WorstOfSteps::include(const TransientState& state) {
  evidence = worst_of(evidence, state.evidence);
  iterations = std::max(iterations, state.iterations);
}

void add_evidence(Table& summary, const Evidence& evidence, const Judged& judged) {
  require_evidence(evidence, judged.condition.value_or(1), judged.iterations, judged.accepted);
  const Rounding rounding{"value", 1e-12};
  summary.add({"residual", evidence.residual, "1"}, rounding);
  summary.add({"bound_violation", evidence.bound_violation(), "1"}, rounding);
  summary.add({"slip_violation", evidence.slip_violation(), "1"}, rounding);
  summary.add({"bound_resolution", evidence.bound_resolution(), "1"}, rounding);
  if (judged.steady) summary.add({"dissipation_error", evidence.dissipation_error(), "1"});
  if (evidence.change > 0) summary.add({"change", evidence.change, "1"});
  if (judged.condition) summary.add({"condition", *judged.condition, "1"});
  const auto doubt =
      judged.doubt ? judged.doubt : doubt_of(evidence, judged.accepted, judged.steady);
  summary.add({"warning", doubt.value_or("none"), "1"});
}

std::string second_solution(SlipBranch branch) {
  const bool least = branch == SlipBranch::least;
  return fmt::format(
      "there is a second solution, of bodies that {}, as friction falls with slip "
      "(contact.slip_branch {})",
      least ? "slide faster" : "slide more slowly", least ? "most" : "least");
}

std::string second_solution_in_steps(std::size_t steps, SlipBranch branch) {
  return fmt::format("in {} step{}, {}; with a longer contact.friction_memory there is none", steps,
                     steps == 1 ? "" : "s", second_solution(branch));
}

std::optional<std::string> both(const std::optional<std::string>& first,
                                const std::optional<std::string>& second) {
  return first && second ? *first + "; " + *second : first ? first : second;
}

Column second_solution_column() {
  return {"second_solution", "1", "1 if there is another one, with other slip"};
}

}  // namespace microslip::experiments
