// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace microslip {

/// The whole text as a decimal number.
template <class Number>
std::optional<Number> converted(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

inline std::optional<double> finite_number(const std::string& text) {
  const auto value = converted<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace microslip
