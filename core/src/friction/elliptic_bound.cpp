// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/elliptic_bound.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

using std::numbers::pi;

EllipticBound::EllipticBound(double half_width, double lateral_half_width, double peak)
    : a_(half_width), b_(lateral_half_width), peak_(peak) {
  require_positive("half_width", a_);
  require_positive("lateral_half_width", b_);
  require_positive("peak", peak_);
}

double EllipticBound::size() const { return std::sqrt(a_ * b_); }

double EllipticBound::operator()(double x, double y) const {
  return peak_ * std::sqrt(std::max(0.0, 1 - std::pow(x / a_, 2) - std::pow(y / b_, 2)));
}

double EllipticBound::total() const { return 2 * pi / 3 * a_ * b_ * peak_; }

/// The integral of g r over the ellipse, by its perimeter.
double EllipticBound::turning_moment() const {
  const double longer = std::max(a_, b_), part = std::min(a_, b_) / longer;
  const double perimeter = 4 * longer * boost::math::ellint_2(std::sqrt(1 - part * part));
  return pi / 16 * perimeter * a_ * b_ * peak_;
}

}  // namespace microslip
