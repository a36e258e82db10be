// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/rule.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "microslip/support/format.hpp"

namespace microslip::experiments {

namespace {

bool contains(const Range& range, double number) {
  const auto beyond = [&](double a, double b) { return range.with_ends ? a > b : a >= b; };
  return !(range.least && beyond(*range.least, number)) &&
         !(range.most && beyond(number, *range.most));
}

std::string in_prose(std::string verdict) {
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  return verdict;
}

std::string sentence(const std::vector<Condition>& conditions) {
  std::string text;
  for (const Condition& condition : conditions) {
    text += fmt::format("{}{} {}", text.empty() ? "" : " and ", condition.quantity,
                        condition.range.words);
  }
  return text;
}

}  // namespace

Range above(double limit) { return {.least = limit, .words = "is above " + format_short(limit)}; }

Range below(double limit) { return {.most = limit, .words = "is below " + format_short(limit)}; }

Range between(double least, double most) {
  return {.least = least,
          .most = most,
          .words = fmt::format("is between {} and {}", format_short(least), format_short(most)),
          .tolerance = (most - least) / 2};
}

Range equal_to(double number) {
  return {.least = number,
          .most = number,
          .with_ends = true,
          .words = "is " + format_short(number),
          .tolerance = 0};
}

Range within(double tolerance, double of) {
  return {.least = of - tolerance,
          .most = of + tolerance,
          .with_ends = true,
          .words = fmt::format("is within {} of {}", format_short(tolerance), format_short(of)),
          .tolerance = tolerance};
}

Range within_percent(double percent, double of) {
  Range range = within(percent / 100 * std::abs(of), of);
  range.words = fmt::format("is within {} % of {}", format_short(percent), format_short(of));
  return range;
}

Rule holds_if(std::vector<Condition> conditions) {
  return {.rulings = {{"reproduced", std::move(conditions)}}, .otherwise = "refuted"};
}

Rule holds_if(std::vector<Condition> conditions, std::vector<Condition> corrected) {
  return {.rulings = {{"reproduced", std::move(conditions)}, {"corrected", std::move(corrected)}},
          .otherwise = "refuted"};
}

Rule corrected_if(std::vector<Condition> conditions, std::string otherwise) {
  return {.rulings = {{"corrected", std::move(conditions)}}, .otherwise = std::move(otherwise)};
}

Rule ours_if(std::vector<Condition> conditions) {
  return {.rulings = {{"ours", std::move(conditions)}}, .otherwise = "refuted"};
}

Rule not_comparable(std::string reason) {
  return {.rulings = {}, .otherwise = "not_comparable", .reason = std::move(reason)};
}

std::string verdict(const Rule& rule, double measured_value) {
  const auto value = [&](const Condition& c) { return c.value.value_or(measured_value); };
  bool measured = !std::isnan(measured_value);
  for (const Ruling& ruling : rule.rulings) {
    for (const Condition& c : ruling.conditions) measured = measured && !std::isnan(value(c));
  }
  if (!measured) return "not_comparable";
  for (const Ruling& ruling : rule.rulings) {
    const auto holds = [&](const Condition& c) { return contains(c.range, value(c)); };
    if (std::all_of(ruling.conditions.begin(), ruling.conditions.end(), holds)) {
      return ruling.verdict;
    }
  }
  return rule.otherwise;
}

std::string sentence(const Rule& rule) {
  std::string text;
  for (const Ruling& ruling : rule.rulings) {
    if (ruling.conditions.empty()) throw std::logic_error("a ruling without a condition");
    text += fmt::format("{} if {}; ", in_prose(ruling.verdict), sentence(ruling.conditions));
  }
  if (!text.empty()) return text + "otherwise " + in_prose(rule.otherwise);
  if (rule.reason.empty()) throw std::logic_error("a rule without rulings and without a reason");
  return fmt::format("{}: {}", in_prose(rule.otherwise), rule.reason);
}

double tolerance(const Rule& rule) {
  if (rule.rulings.empty()) return not_given;
  return rule.rulings.front().conditions.front().range.tolerance;
}

double rounding_of(const Rule& rule) {
  constexpr double largest = 1e-8;
  if (rule.rulings.empty() || rule.rulings.front().conditions.empty()) return 0;
  const auto& [least, most, with_ends, words, tolerance] =
      rule.rulings.front().conditions.front().range;
  const bool about_zero = least && most && *least == -*most;
  return about_zero && tolerance <= largest ? tolerance : 0;
}

}  // namespace microslip::experiments
