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
               double direction)
    : compliance_(compliance(material)),
      bound_(bound),
      stick_ratio_(stick_ratio),
      direction_(direction) {}

Carter Carter::from_creepage(const Material& material, const HertzBound& bound, double creepage) {
  const double sliding = compliance(material) * bound.peak();
  require(true, "load.creepage", creepage, "a finite number");
  return {material, bound, std::max(0.0, 1 - std::abs(creepage) / sliding), direction_of(creepage)};
}

Carter Carter::from_stick_ratio(const Material& material, const HertzBound& bound,
                                double stick_ratio) {
  require(stick_ratio >= 0 && stick_ratio <= 1, "stick ratio", stick_ratio, "a number in [0, 1]");
  return from_creepage(material, bound, compliance(material) * bound.peak() * (1 - stick_ratio));
}

Carter Carter::from_force(const Material& material, const HertzBound& bound, double force) {
  const double sliding = bound.total();
  require(std::abs(force) <= sliding, "load.force", force,
          "an absolute value up to full sliding, " + format_short(sliding));
  return {material, bound, std::sqrt(1 - std::abs(force) / sliding), direction_of(-force)};
}

double Carter::creepage() const {
  return direction_ * compliance_ * bound_.peak() * (1 - stick_ratio_);
}

double Carter::force() const {
  return -direction_ * bound_.total() * (1 - stick_ratio_) * (1 + stick_ratio_);
}

double Carter::traction(double x) const {
  // Inside the stick zone, sqrt(a'^2 - (r - d)^2) with d = 1 - a', from the distances to its ends.
  const double r = x / bound_.half_width();
  const double stuck = std::max(0.0, (1 - r) * (r - 1 + 2 * stick_ratio_));
  return -direction_ * (bound_(x) - bound_.peak() * std::sqrt(stuck));
}

double Carter::slip(double x) const {
  const double r = x / bound_.half_width();
  const double beyond = std::max(0.0, (1 - r) * (1 - 2 * stick_ratio_ - r));
  return direction_ * compliance_ * bound_.peak() * std::sqrt(beyond);
}

}  // namespace microslip
