// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/fretting_cycle.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

/// 2 (1 - t) ln(1 - t) + 2 t - t^2 for t in [0, 1]. In this form, two thirds of the digits would
/// cancel at small t.
double lost_part(double t) {
  if (t >= 0.5) return (t < 1 ? 2 * (1 - t) * std::log1p(-t) : 0) + 2 * t - t * t;
  double sum = 0;
  double power = 2 * t * t * t;
  for (int n = 3; power > std::numeric_limits<double>::epsilon() * sum; ++n, power *= t) {
    sum += power / (n * (n - 1));
  }
  return sum;
}

}  // namespace

FrettingCycle::FrettingCycle(const Material& material, const HertzBound& bound, double force)
    : material_(material), bound_(bound), end_(force), at_end_(material, bound, force) {}

/// Half of the change since F*.
Cattaneo FrettingCycle::change(double force) const {
  require(std::abs(force) <= std::abs(end_), "force", force,
          "an absolute value up to that at the end, " + format_short(std::abs(end_)));
  return {material_, bound_, end_ / 2 - force / 2};
}

double FrettingCycle::traction(double x, double force) const {
  return at_end_.traction(x) - 2 * change(force).traction(x);
}

double FrettingCycle::shift(double force, double length) const {
  return 2 * change(force).displacement(length) - at_end_.displacement(length);
}

double FrettingCycle::dissipation() const {
  const double sliding = bound_.total();
  return compliance(material_) / std::numbers::pi * sliding * sliding *
         lost_part(std::abs(end_) / sliding);
}

}  // namespace microslip
