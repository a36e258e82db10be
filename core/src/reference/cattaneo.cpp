// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/cattaneo.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

Cattaneo::Cattaneo(const Material& material, const HertzBound& bound, double force)
    : compliance_(compliance(material)), bound_(bound), direction_(force < 0 ? -1 : 1) {
  const double sliding = bound.total();
  require(std::abs(force) <= sliding, "force", force,
          "an absolute value up to full sliding, " + format_short(sliding));
  stick_ratio_ = std::sqrt(1 - std::abs(force) / sliding);
}

double Cattaneo::traction(double x) const {
  const double r = x / bound_.half_width();
  const double stuck = std::max(0.0, (stick_ratio_ - r) * (stick_ratio_ + r));
  return direction_ * (bound_(x) - bound_.peak() * std::sqrt(stuck));
}

double Cattaneo::displacement(double length) const {
  require_positive("kernel.length", length);
  // Of an ellipse of unit height and half-width k, in its middle: k^2 (ln(2 L0 / k) + 1/2) / 2.
  const double k = stick_ratio_;
  const double whole = std::log(2 * length / bound_.half_width()) + 0.5;
  const double removed = k > 0 ? k * k * (whole - std::log(k)) : 0;
  return direction_ * compliance_ * bound_.peak() * bound_.half_width() * (whole - removed) / 2;
}

}  // namespace microslip
