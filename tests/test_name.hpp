// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as parts of tests' names.
#pragma once

#include <cctype>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <utility>

namespace microslip::test {

/// A number with its 6 leading digits as a part of a test's name: -2.5e-13 is m2p5em13.
inline std::string in_a_name(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  std::string name;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c == '-') name += 'm';
    if (*c == '.') name += 'p';
    const bool zero_of_exponent =
        *c == '0' && !name.empty() && (name.ends_with("e") || name.ends_with("em"));
    if (std::isalnum(static_cast<unsigned char>(*c)) != 0 && !zero_of_exponent) name += *c;
  }
  return name;
}

/// Where an error is met: {{"c", 1e-12}, {"offset", 0}} is c_1em12_offset_0.
inline std::string place(std::initializer_list<std::pair<const char*, double>> coordinates) {
  std::string name;
  for (const auto& [coordinate, value] : coordinates) {
    if (!name.empty()) name += '_';
    name.append(coordinate).append("_").append(in_a_name(value));
  }
  return name;
}

}  // namespace microslip::test
