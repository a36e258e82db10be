// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/not_converged.hpp"

#include "microslip/support/format.hpp"

namespace microslip {

NotConverged::NotConverged(const std::string& what, int iterations, double residual)
    : std::runtime_error(what + " after " + std::to_string(iterations) +
                         " iterations; largest relative violation " + format_short(residual)),
      iterations_(iterations),
      residual_(residual) {}

}  // namespace microslip
