// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/not_converged.hpp"

#include <fmt/core.h>

#include "microslip/support/format.hpp"

namespace microslip {

NotConverged::NotConverged(const std::string& what, int iterations, double residual)
    : std::runtime_error(fmt::format("{} after {} iterations; largest relative violation {}", what,
                                     iterations, format_short(residual))),
      iterations_(iterations),
      residual_(residual) {}

}  // namespace microslip
