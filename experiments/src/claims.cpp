// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/claims.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"

namespace microslip::experiments {

std::string text_above_rounding(double value, double bound) {
  return std::abs(value) <= bound ? "below " + format_short(bound) : format_short(value);
}

namespace {

constexpr const char* measured_value = "measured_value";
constexpr const char* description = "claims of the thesis, and measurements";

std::vector<Column> columns() {
  return {{"claim", "1", "the thesis's statement"},
          {"section", "1", "where it stands"},
          {"thesis_value", "see unit", "its number; nan if it gives none"},
          {measured_value, "see unit", "ours"},
          {"unit", "1", "unit of the two, and of the tolerance"},
          {"rule", "1", "how the verdict follows; without a measured value it is not_comparable"},
          {"tolerance", "see unit",
           "half the width of the first range that the rule names; nan if that has one bound"},
          {"verdict", "1",
           "reproduced, corrected, refuted, not_comparable, ours: not of the thesis, or "
           "not_judged: the run has other parameters than the study"},
          {"note", "1", "meaning of the measured value, and its conditions"},
          {"figure", "1", "name of the figure that shows it, or none"}};
}

/// Adds a row to the claims.
/// \param rounding  a measured value up to this is rounding only; 0 if none is
void add(Table& claims, std::vector<Cell> row, double rounding) {
  if (rounding > 0) {
    claims.add(std::move(row), {measured_value, rounding});
  } else {
    claims.add(std::move(row));
  }
}

Table not_judged(const Table& claims, const std::vector<std::string>& changed) {
  Table table(claims.name(),
              fmt::format("{}; not judged: this run has other parameters than the study: {}",
                          description, joined(changed, ", ")),
              claims.columns());
  for (std::size_t i = 0; i < claims.rows(); ++i) {
    std::vector<Cell> row;
    for (const Column& column : claims.columns()) {
      row.push_back(column.name == "verdict" ? "not_judged" : claims.at(i, column.name));
    }
    add(table, std::move(row), claims.rounding(i, measured_value));
  }
  return table;
}

}  // namespace

Table claims_table(const std::vector<Claim>& claims) {
  constexpr std::array verdicts = {"reproduced", "corrected", "refuted", "not_comparable", "ours"};
  Table table("claims", description, columns());
  for (const auto& [claim, section, thesis, measured, unit, rule, note, figure, rounding] :
       claims) {
    const std::string given = verdict(rule, measured);
    if (std::find(verdicts.begin(), verdicts.end(), given) == verdicts.end()) {
      throw std::logic_error(fmt::format("claim '{}': no such verdict: {}", claim, given));
    }
    if (figure.empty()) {
      throw std::logic_error(fmt::format("claim '{}': no figure, not even none", claim));
    }
    add(table,
        {claim, section, thesis, measured, unit, sentence(rule), tolerance(rule), given, note,
         figure},
        std::max(rounding, rounding_of(rule)));
  }
  return table;
}

std::vector<Table> judged_unless_changed(std::vector<Table> tables,
                                         const std::vector<std::string>& changed) {
  if (changed.empty()) return tables;
  for (Table& table : tables) {
    if (table.name() == "claims") table = not_judged(table, changed);
  }
  return tables;
}

}  // namespace microslip::experiments
