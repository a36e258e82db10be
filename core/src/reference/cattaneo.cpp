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
  const double size = std::abs(force);
  require(size <= sliding, "force", force,
          "an absolute value up to full sliding, " + format_short(sliding));
  force_ratio_ = size / sliding;
  held_ratio_ = (sliding - size) / sliding;
  stick_ratio_ = std::sqrt(held_ratio_);
}

double Cattaneo::traction(double x) const {
  const double a = bound_.half_width();
  const double r = x / a;
  const double under_bound = (a - x) / a * ((a + x) / a);
  // k^2 - r^2, as a sum of small terms: next to full adhesion the edges of stick zone and contact
  // coincide.
  const double stuck = force_ratio_ < 0.5 ? under_bound - force_ratio_ : held_ratio_ - r * r;
  if (stuck <= 0 || under_bound <= 0) return direction_ * bound_(x);
  // The difference of both ellipses, from the difference of their squares.
  return direction_ * bound_.peak() * force_ratio_ / (std::sqrt(under_bound) + std::sqrt(stuck));
}

double Cattaneo::displacement(double length) const {
  require_positive("length", length);
  // An ellipse of unit height and half-width k displaces its centre by k^2 (ln(2 L0 / k) + 1/2) /
  // 2.
  const double whole = std::log(2 * length / bound_.half_width()) + 0.5;
  const double log_held = force_ratio_ < 0.5 ? std::log1p(-force_ratio_) : std::log(held_ratio_);
  const double of_edge = held_ratio_ > 0 ? held_ratio_ * log_held / 2 : 0;
  return direction_ * compliance_ * bound_.peak() * bound_.half_width() *
         (force_ratio_ * whole + of_edge) / 2;
}

}  // namespace microslip
