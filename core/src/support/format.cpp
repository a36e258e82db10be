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

std::pair<std::string, std::string> format_apart(double a, double b) {
  for (int digits = 2;; ++digits) {
    std::pair texts(to_string(a, std::chars_format::general, digits),
                    to_string(b, std::chars_format::general, digits));
    if (texts.first != texts.second || digits == 17) return texts;
  }
}

std::string format_percent(double share) {
  const double percent = 100 * share;
  const bool is_long = std::abs(percent) >= 99.5;
  return (is_long ? to_string(percent, std::chars_format::fixed, 0) : format_roughly(percent)) +
         " %";
}

std::string format_full(double value) { return to_string(value, std::chars_format::general, 17); }

}  // namespace microslip
