// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/nearest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <string_view>

#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& names,
                    std::size_t most) {
  std::size_t best = most + 1;
  std::string found;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(word, name);
    if (distance == 0 || distance >= best) continue;
    best = distance;
    found = name;
  }
  return found;
}

std::string suggestion(const std::string& meant) {
  return meant.empty() ? "" : fmt::format(" (did you mean '{}'?)", shown(meant));
}

}  // namespace microslip
