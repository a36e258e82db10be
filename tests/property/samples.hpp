// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string_view>

namespace microslip {

/// Tells whether tests take all that they can, with MICROSLIP_SAMPLES=all, as in `make thorough`.
inline bool takes_all_samples() {
  const char* given = std::getenv("MICROSLIP_SAMPLES");
  return given != nullptr && std::string_view(given) == "all";
}

/// Says how many of the generated cases a test takes: a sixth, or all.
inline int samples(int all) { return takes_all_samples() ? all : (all + 5) / 6; }

/// The same for cases that take long, with a number of its own.
inline int samples(int all, int some) { return takes_all_samples() ? all : some; }

}  // namespace microslip
