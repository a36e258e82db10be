// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/experiments/rule.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Returns number `i` of `count` values from `first` to `last` in equal ratios.
/// \param count  >= 2
template <class Number>
double log_spaced(double first, double last, Number i, Number count) {
  const double part = static_cast<double>(i) / static_cast<double>(count - 1);
  return std::clamp(first * std::pow(last / first, part), first, last);
}

/// Lists stick ratios close to one stick ratio, such that the stick-slip points lie at so many
/// different places of an element.
/// \param elements  N
/// \return          in (0, 1)
inline std::vector<double> aligned_stick_ratios(double stick_ratio, int alignments,
                                                Eigen::Index elements) {
  std::vector<double> ratios;
  for (int j = 0; j < alignments; ++j) {
    const double moved =
        stick_ratio + static_cast<double>(j) / alignments / static_cast<double>(elements);
    ratios.push_back(moved < 1 ? moved : 2 * stick_ratio - moved);
  }
  return ratios;
}

/// Finds the least or the largest number of a column, among the wanted rows.
/// \param wanted  takes the index of a row
/// \return        not_given if no row is wanted
template <class Wanted>
double extreme(const Table& table, const char* column, bool least, const Wanted& wanted) {
  double found = not_given;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!wanted(i)) continue;
    const double value = table.number(i, column);
    found = least ? std::fmin(found, value) : std::fmax(found, value);
  }
  return found;
}

using Cells = std::vector<std::pair<std::string, Cell>>;

inline bool has(const Table& table, std::size_t row, const Cells& cells) {
  return std::ranges::all_of(
      cells, [&](const auto& cell) { return table.at(row, cell.first) == cell.second; });
}

/// The least and the largest number of a column, among the rows with the given cells.
inline double least(const Table& table, const char* column, const Cells& cells) {
  return extreme(table, column, true, [&](std::size_t i) { return has(table, i, cells); });
}
inline double most(const Table& table, const char* column, const Cells& cells) {
  return extreme(table, column, false, [&](std::size_t i) { return has(table, i, cells); });
}

}  // namespace microslip::experiments
