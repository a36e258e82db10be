// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string_view>

namespace microslip {

/// Says how many of the generated cases a test takes: a third, or all with MICROSLIP_SAMPLES=all, as
/// `make verify` has it.
inline int samples(int all) {
  const char* given = std::getenv("MICROSLIP_SAMPLES");
  return given != nullptr && std::string_view(given) == "all" ? all : (all + 2) / 3;
}

}  // namespace microslip
