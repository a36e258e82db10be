// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/fastsim.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

Fastsim::Fastsim(double half_width, double most, double slope)
    : half_width_(half_width), most_(most), slope_(slope) {
  require_positive("half_width", half_width);
  require_positive("full_sliding_force", most);
  require_positive("slope", slope);
}

double Fastsim::flexibility() const { return 2 * half_width_ * half_width_ / slope_; }

double Fastsim::force(double creepage) const {
  const double part = std::min(1.0, std::abs(creepage) / full_sliding_creepage());
  const double size = most_ * part * (3 - part * (3 - part));
  return creepage > 0 ? -size : size;
}

double Fastsim::traction(double x, double creepage) const {
  if (!(std::abs(x) < half_width_)) return 0;
  const double peak = 0.75 * most_ / half_width_;
  const double parabola = peak * (1 - x / half_width_) * (1 + x / half_width_);
  const double grown = std::abs(creepage) * (half_width_ - x) / flexibility();
  const double size = std::min(parabola, grown);
  return creepage > 0 ? -size : size;
}

}  // namespace microslip
