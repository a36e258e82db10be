// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/not_converged.hpp"

#include <fmt/core.h>

#include "microslip/support/format.hpp"

namespace microslip {

namespace {

std::string message_of(const std::string& what, int iterations, double residual) {
  return iterations == 0
             ? what
             : fmt::format("{} after {} {}; largest relative violation {}", what, iterations,
                           iterations == 1 ? "iteration" : "iterations", format_roughly(residual));
}

}  // namespace

NotConverged::NotConverged(const std::string& what, int iterations, double residual)
    : std::runtime_error(message_of(what, iterations, residual)),
      iterations_(iterations),
      residual_(residual) {}

}  // namespace microslip
