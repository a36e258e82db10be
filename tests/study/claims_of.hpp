// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// The verdicts of a study's claims, in their order.
inline std::vector<std::string> verdicts(const std::vector<Table>& tables) {
  for (const Table& table : tables) {
    if (table.name() != "claims") continue;
    std::vector<std::string> all;
    for (std::size_t i = 0; i < table.rows(); ++i) {
      all.push_back(std::get<std::string>(table.at(i, "verdict")));
    }
    return all;
  }
  throw std::logic_error("the study has no claims");
}

}  // namespace microslip::experiments
