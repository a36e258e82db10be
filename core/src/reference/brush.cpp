// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/brush.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

Brush::Brush(double compliance, const HertzBound& bound) : compliance_(compliance), bound_(bound) {
  require_positive("compliance", compliance);
}

/// m
double Brush::growth(double creepage) const {
  return std::abs(creepage) * bound_.half_width() / (compliance_ * bound_.peak());
}

double Brush::force(double creepage) const {
  const double m = growth(creepage);
  const double size = bound_.half_width() * bound_.peak() * (m / (1 + m * m) + std::atan(m));
  return creepage > 0 ? -size : size;
}

double Brush::stick_edge(double creepage) const {
  const double m = growth(creepage);
  return bound_.half_width() * (1 - 2 / (1 + m * m));
}

double Brush::traction(double x, double creepage) const {
  if (!(std::abs(x) < bound_.half_width())) return 0;
  const double grown = std::abs(creepage) * (bound_.half_width() - x) / compliance_;
  const double size = std::min(bound_(x), grown);
  return creepage > 0 ? -size : size;
}

}  // namespace microslip
