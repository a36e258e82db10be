// SPDX-License-Identifier: GPL-3.0-or-later
#include "tolerances.hpp"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace microslip::tools {

Tolerances::Tolerances(std::istream& in) {
  for (std::string text; std::getline(in, text);) {
    std::istringstream words(text.substr(0, text.find('#')));
    if ((words >> std::ws).eof()) continue;
    Line line;
    auto& [relative, of_largest, absolute] = line.tolerance;
    std::string rest;
    words >> line.table >> line.column;
    if (line.column != "none") words >> relative >> of_largest >> absolute;
    if (!words || words >> rest || std::min({relative, of_largest, absolute}) < 0) {
      throw std::invalid_argument(fmt::format(
          "tolerances: '{}': expected patterns of table and column, and three numbers", text));
    }
    lines_.push_back(line);
  }
}

const Tolerances::Line* Tolerances::last(const std::string& table,
                                         const std::string& column) const {
  const auto matches = [](const std::string& pattern, const std::string& name) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  };
  const auto line = std::find_if(lines_.rbegin(), lines_.rend(), [&](const Line& candidate) {
    return matches(candidate.table, table) && matches(candidate.column, column);
  });
  return line == lines_.rend() ? nullptr : &*line;
}

bool Tolerances::has_reference(const std::string& table) const {
  return last(table, "none") == nullptr || last(table, "none")->column != "none";
}

Tolerance Tolerances::of(const std::string& table, const std::string& column) const {
  const Line* line = last(table, column);
  if (line == nullptr) {
    throw std::invalid_argument(fmt::format("tolerances: none for column {} of {}", column, table));
  }
  return line->tolerance;
}

}  // namespace microslip::tools
