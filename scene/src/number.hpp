// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// The text without a plus sign in front of a number; std::from_chars does not accept that sign.
inline std::string_view without_plus(std::string_view text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return has_plus ? text.substr(1) : text;
}

/// The whole text as a decimal number, with a decimal point in any locale.
template <class Number>
std::optional<Number> converted(std::string_view text) {
  Number value{};
  text = without_plus(text);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// The whole text as a finite number. None also for a nonzero number too small for a double: 1e-400
/// would silently become 0.
inline std::optional<double> finite_number(std::string_view text) {
  const auto value = converted<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// The text as a whole number, also written as 1e5 or 20.0; in these forms up to 2^53, below which
/// doubles are exact.
std::optional<Eigen::Index> whole_number(std::string_view text);

/// The shortest texts of numbers, separated by blanks.
std::string joined_numbers(const std::vector<double>& values);

/// Advice on a text that is nearly a number, e.g. " with a decimal point" for 1,5; it follows "a
/// number" in a message. Empty if there is no advice.
std::string advice(const std::string& text);

}  // namespace microslip
