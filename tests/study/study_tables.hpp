// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::experiments {

inline const Table& table_named(const std::vector<Table>& tables, const std::string& name) {
  for (const Table& table : tables) {
    if (table.name() == name) return table;
  }
  throw std::logic_error("the study has no table " + name);
}

/// The verdicts of a study's claims, in their order.
inline std::vector<std::string> verdicts(const std::vector<Table>& tables) {
  const Table& claims = table_named(tables, "claims");
  std::vector<std::string> all;
  for (std::size_t i = 0; i < claims.rows(); ++i) {
    all.push_back(std::get<std::string>(claims.at(i, "verdict")));
  }
  return all;
}

}  // namespace microslip::experiments
