// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/traction_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

HertzBound::HertzBound(double half_width, double peak) : half_width_(half_width), peak_(peak) {
  require_positive("contact.half_width", half_width);
  require_positive("contact.peak_traction", peak);
}

double HertzBound::operator()(double x) const {
  const double r = x / half_width_;
  return peak_ * std::sqrt(std::max(0.0, (1 - r) * (1 + r)));
}

Eigen::VectorXd HertzBound::operator()(const Eigen::VectorXd& x) const {
  return x.unaryExpr([this](double xi) { return (*this)(xi); });
}

double HertzBound::total() const { return std::numbers::pi / 2 * half_width_ * peak_; }

}  // namespace microslip
