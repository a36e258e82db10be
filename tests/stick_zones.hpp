// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/friction/active_set.hpp"

namespace microslip {

/// Number of intervals of elements in adhesion.
inline int stick_zones(const std::vector<Zone>& zones) {
  int count = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const bool begins = i == 0 || zones[i - 1] != Zone::adhesion;
    count += begins && zones[i] == Zone::adhesion ? 1 : 0;
  }
  return count;
}

}  // namespace microslip
