// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/carter.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

double direction_of(double creepage) { return creepage < 0 ? -1 : 1; }

}  // namespace

Carter::Carter(const Material& material, const HertzBound& bound, double stick_ratio,
               double slip_ratio, double direction)
    : compliance_(compliance(material)),
      bound_(bound),
      stick_ratio_(stick_ratio),
      slip_ratio_(slip_ratio),
      direction_(direction) {}

Carter Carter::from_creepage(const Material& material, const HertzBound& bound, double creepage) {
  const double sliding = compliance(material) * bound.peak();
  require(true, "creepage", creepage, "a finite number");
  const double size = std::min(std::abs(creepage), sliding);
  return {material, bound, (sliding - size) / sliding, size / sliding, direction_of(creepage)};
}

Carter Carter::from_stick_ratio(const Material& material, const HertzBound& bound,
                                double stick_ratio) {
  require(stick_ratio >= 0 && stick_ratio <= 1, "stick ratio", stick_ratio, "a number in [0, 1]");
  return {material, bound, stick_ratio, 1 - stick_ratio, 1};
}

Carter Carter::from_force(const Material& material, const HertzBound& bound, double force) {
  const double sliding = bound.total();
  const double size = std::abs(force);
  require(size <= sliding, "force", force,
          "an absolute value up to full sliding, " + format_short(sliding));
  const double stick_ratio = std::sqrt((sliding - size) / sliding);
  return {material, bound, stick_ratio, size / sliding / (1 + stick_ratio), direction_of(-force)};
}

double Carter::creepage() const { return direction_ * compliance_ * bound_.peak() * slip_ratio_; }

double Carter::force() const {
  return -direction_ * bound_.total() * slip_ratio_ * (1 + stick_ratio_);
}

/// Distance from the stick-slip point towards the leading edge, over a. The distance is computed
/// from the edge nearer to that point.
double Carter::into_adhesion(double x) const {
  const double a = bound_.half_width();
  return slip_ratio_ < stick_ratio_ ? (a + x) / a - 2 * slip_ratio_
                                    : 2 * stick_ratio_ - (a - x) / a;
}

double Carter::traction(double x) const {
  const double inside = into_adhesion(x);
  if (inside <= 0 || std::abs(x) >= bound_.half_width()) return -direction_ * bound_(x);
  // The bound minus the smaller ellipse, from the difference of the squares of both.
  const double to_leading = (bound_.half_width() - x) / bound_.half_width();
  const double to_trailing = (bound_.half_width() + x) / bound_.half_width();
  return -direction_ * bound_.peak() * 2 * slip_ratio_ * std::sqrt(to_leading) /
         (std::sqrt(to_trailing) + std::sqrt(inside));
}

double Carter::slip(double x) const {
  const double to_leading = (bound_.half_width() - x) / bound_.half_width();
  const double beyond = std::max(0.0, to_leading * -into_adhesion(x));
  return direction_ * compliance_ * bound_.peak() * std::sqrt(beyond);
}

}  // namespace microslip
