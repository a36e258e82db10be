// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/format.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace microslip {

namespace {

template <class... Style>
std::string to_string(double value, Style... style) {
  if (std::isnan(value)) return "nan";  // of either sign
  std::array<char, 64> text;
  const double without_sign_of_zero = value + 0.0;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), without_sign_of_zero, style...).ptr;
  return {text.data(), end};
}

}  // namespace

std::string format_short(double value) { return to_string(value); }

std::string format_roughly(double value) { return to_string(value, std::chars_format::general, 2); }

std::string format_full(double value) { return to_string(value, std::chars_format::general, 17); }

}  // namespace microslip
