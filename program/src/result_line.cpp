// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"

namespace microslip::program {

namespace {

const Table* table_named(const std::vector<Table>& tables, const std::string& name,
                         const std::string& column) {
  const auto found = std::ranges::find_if(
      tables, [&](const Table& table) { return table.name() == name && table.has(column); });
  return found == tables.end() ? nullptr : &*found;
}

/// The value of a quantity of a summary, with its unit.
std::optional<std::string> value_of(const Table& summary, const std::string& quantity) {
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    if (std::get<std::string>(summary.at(i, "quantity")) != quantity) continue;
    const Cell& cell = summary.at(i, "value");
    const auto* number = std::get_if<double>(&cell);
    const bool is_rounding = number != nullptr && std::abs(*number) <= summary.rounding(i, "value");
    const std::string text = number == nullptr
                                 ? std::get<std::string>(cell)
                                 : fmt::format("{:.6g}", is_rounding ? 0 : *number + 0.0);
    const std::string unit = std::get<std::string>(summary.at(i, "unit"));
    return unit == "1" ? text : text + " " + unit;
  }
  return std::nullopt;
}

std::vector<std::string> facts_of(const Table& summary) {
  constexpr struct {
    const char* quantity;
    const char* text;
    bool if_any = false;  ///< left out where it is 0
  } wanted[] = {{"force", "force {}"},        {"lateral_force", "lateral force {}"},
                {"spin_moment", "moment {}"}, {"force_ratio", "{} of full sliding"},
                {"creepage", "creepage {}"},  {"lateral_creepage", "lateral creepage {}", true},
                {"spin", "spin {}", true},    {"velocity", "velocity {}"},
                {"method", "by {}"}};
  std::vector<std::string> facts;
  for (const auto& [quantity, text, if_any] : wanted) {
    const auto value = value_of(summary, quantity);
    if (!value || (if_any && (value == "0" || value->starts_with("0 ")))) continue;
    facts.push_back(fmt::format(fmt::runtime(text), *value));
  }
  return facts;
}

/// "5 claims reproduced, 1 refuted"
std::vector<std::string> verdicts_of(const Table& claims) {
  std::vector<std::pair<std::string, int>> counts;
  for (std::size_t i = 0; i < claims.rows(); ++i) {
    const std::string verdict = std::get<std::string>(claims.at(i, "verdict"));
    auto found = std::ranges::find(counts, verdict, &std::pair<std::string, int>::first);
    if (found == counts.end()) found = counts.insert(counts.end(), {verdict, 0});
    ++found->second;
  }
  std::vector<std::string> facts;
  for (const auto& [verdict, count] : counts) {
    std::string words = verdict;
    std::ranges::replace(words, '_', ' ');
    facts.push_back(fmt::format("{}{} {}", count,
                                facts.empty() ? (count == 1 ? " claim" : " claims") : "", words));
  }
  return facts;
}

}  // namespace

std::string result_line(const std::string& program, const std::vector<Table>& tables,
                        const std::string& folder) {
  std::vector<std::string> facts;
  if (const Table* claims = table_named(tables, "claims", "verdict")) {
    facts = verdicts_of(*claims);
  } else if (const Table* summary = table_named(tables, "summary", "quantity")) {
    facts = facts_of(*summary);
  }
  const std::string behind = facts.empty() ? "" : "; ";
  return fmt::format("{}: {}{}tables in {}", program, joined(facts, ", "), behind, shown(folder));
}

}  // namespace microslip::program
