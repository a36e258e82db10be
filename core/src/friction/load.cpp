// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/load.hpp"

#include <cmath>
#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

ShiftLoad over_length(const Load& load, double length) {
  if (const auto* force = std::get_if<PrescribedForce>(&load)) return *force;
  return PrescribedShift{std::get<PrescribedCreepage>(load).value * length};
}

void require_below_full_sliding(double force, double full_sliding, std::string_view name) {
  require(std::abs(force) < full_sliding, name, force,
          [&] { return "an absolute value below full sliding, " + format_short(full_sliding); });
}

void require_below_full_sliding(const Prescribed& load, double full_sliding) {
  if (load.by_force) return require_below_full_sliding(load.value, full_sliding);
  require(true, "creepage", load.value, "a finite number");
}

}  // namespace microslip
