// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/chebyshev_traction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;

ChebyshevTraction::ChebyshevTraction(double begin, double end, Eigen::VectorXd coefficients)
    : begin_(begin), end_(end), coefficients_(std::move(coefficients)) {}

double ChebyshevTraction::polynomial(double x) const {
  count_work(4 * static_cast<double>(coefficients_.size()));
  // Clenshaw's recurrence.
  const double t = position(x);
  double next = 0;
  double after = 0;
  for (Index n = coefficients_.size() - 1; n >= 0; --n) {
    after = std::exchange(next, coefficients_[n] + 2 * t * next - after);
  }
  return next;
}

double ChebyshevTraction::operator()(double x) const {
  return std::sqrt(std::max(0.0, (x - begin_) * (end_ - x))) / half_length() * polynomial(x);
}

double ChebyshevTraction::integral(double x) const {
  // With t = cos(angle) the terms are sin(angle) sin((n + 1) angle); from the end of the interval.
  const double angle = std::acos(std::clamp(position(x), -1.0, 1.0));
  double above = coefficients_[0] * (angle - std::sin(2 * angle) / 2);
  for (Index n = 1; n < coefficients_.size(); ++n) {
    const auto k = static_cast<double>(n);
    above += coefficients_[n] * (std::sin(k * angle) / k - std::sin((k + 2) * angle) / (k + 2));
  }
  return force() - half_length() / 2 * above;
}

double ChebyshevTraction::force() const {
  return std::numbers::pi / 2 * half_length() * coefficients_[0];
}

}  // namespace microslip
