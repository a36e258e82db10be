// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/chebyshev_traction.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;

namespace {

/// Largest phase, in radians, of a cosine that 15 Gauss points integrate to rounding.
constexpr double longest_panel = 5;

}  // namespace

ChebyshevTraction::ChebyshevTraction(double begin, double end, Eigen::VectorXd coefficients)
    : begin_(begin), end_(end), coefficients_(std::move(coefficients)) {}

double ChebyshevTraction::polynomial(double x) const {
  count_work(4 * static_cast<double>(coefficients_.size()));
  // The sum is made by Clenshaw's recurrence.
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
  // With t = cos(angle) the terms are sin(angle) sin((n + 1) angle). The angle begins at the end of
  // the interval.
  const double angle = std::acos(std::clamp(position(x), -1.0, 1.0));
  double above = coefficients_[0] * (angle - std::sin(2 * angle) / 2);
  for (Index n = 1; n < coefficients_.size(); ++n) {
    const auto k = static_cast<double>(n);
    above += coefficients_[n] * (std::sin(k * angle) / k - std::sin((k + 2) * angle) / (k + 2));
  }
  return force() - half_length() / 2 * above;
}

double ChebyshevTraction::integral(double x, double behind, double before) const {
  using boost::math::quadrature::gauss;
  // The integral is taken over the angle from the nearer end. The integrand is sin^2 times a cosine
  // series, which 15 points per panel integrate to rounding and without cancellation.
  const double half = half_length();
  const double to_begin = (x - begin_) / half;
  const double to_end = (end_ - x) / half;
  const bool from_begin = to_begin < to_end;
  const double inwards = (from_begin ? before : behind) / half;
  const double outwards = (from_begin ? behind : before) / half;
  const double distance = std::min(to_begin, to_end);
  const auto sine = [](double d) { return std::sqrt(std::max(0.0, d * (2 - d))); };
  const double near = std::max(0.0, distance - outwards);
  const double first = std::atan2(sine(near), 1 - near);
  const double range = 2 * std::atan2(inwards + outwards, sine(near) + sine(distance + inwards));
  const auto panels =
      std::ceil(range * static_cast<double>(coefficients_.size() + 1) / longest_panel);
  const double panel = range / panels;
  const auto integrand = [&](double angle) {
    const double s = std::sin(angle);
    const double t = std::cos(angle);
    return s * s * polynomial(centre() + half * (from_begin ? -t : t));
  };
  double sum = 0;
  for (double k = 0; k < panels; ++k) {
    const double begin = first + k * panel;
    const auto within = [&](double part) { return integrand(begin + part * panel); };
    sum += panel * gauss<double, 15>::integrate(within, 0.0, 1.0);
  }
  return half * sum;
}

double ChebyshevTraction::force() const {
  return std::numbers::pi / 2 * half_length() * coefficients_[0];
}

}  // namespace microslip
