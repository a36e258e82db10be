// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/superposed_shift.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "microslip/support/quadrature.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double half_pi = std::numbers::pi / 2;

/// Coefficients below this fraction of the first one are rounding only.
constexpr double rounding = 1e-14;

/// Evaluates T_n(t) for any t in [-1, 1].
double chebyshev(Index n, double t) { return std::cos(static_cast<double>(n) * std::acos(t)); }

/// Integrates -ln|t - t'| U_n(t') sqrt(1 - t'^2) over [-1, 1].
double potential(Index n, double t) {
  if (n == 0) return half_pi * (std::numbers::ln2 - chebyshev(2, t) / 2);
  const auto degree = static_cast<double>(n);
  return half_pi * (chebyshev(n, t) / degree - chebyshev(n + 2, t) / (degree + 2));
}

/// Finds the zero of a function that is negative at the first place and positive at the second.
double root(const std::function<double(double)>& rising, double low, double high) {
  constexpr int most_evaluations = 100;
  std::uintmax_t evaluations = most_evaluations;
  const auto [left, right] = boost::math::tools::toms748_solve(
      rising, low, high, boost::math::tools::eps_tolerance<double>(), evaluations);
  return std::abs(rising(left)) < std::abs(rising(right)) ? left : right;
}

}  // namespace

SuperposedShift::SuperposedShift(const PolynomialBound& bound, double compliance, double length)
    : scale_(bound.half_width()),
      factor_(compliance / std::numbers::pi * bound.half_width()),
      log_length_(std::log(length / bound.half_width())) {
  // Gauss's points of these functions integrate exactly: a bound has degree 32 at most.
  constexpr Index points = 40;
  constexpr Index functions = 33;
  sines_ = VectorXd::Zero(functions);
  for (Index k = 1; k <= points; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / (points + 1);
    const double value = bound(scale_ * std::cos(angle));
    for (Index n = 0; n < sines_.size(); ++n) {
      sines_[n] += 2.0 / (points + 1) * value * std::sin(static_cast<double>(n + 1) * angle);
    }
  }
  Index used = functions;
  while (used > 1 && std::abs(sines_[used - 1]) < rounding * sines_[0]) --used;
  sines_.conservativeResize(used);
}

/// Expands the strain of full sliding on a zone in T_n of the zone: the term U_n times the square
/// root has the strain T_(n+1).
VectorXd SuperposedShift::strain_on(const StickZone& zone) const {
  const Index points = sines_.size() + 1;
  VectorXd series = VectorXd::Zero(points);
  for (Index k = 0; k < points; ++k) {
    const double angle =
        std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(points);
    double strain = 0;
    for (Index n = 0; n < sines_.size(); ++n) {
      strain += sines_[n] * chebyshev(n + 1, zone.centre + zone.half_length * std::cos(angle));
    }
    for (Index n = 0; n < points; ++n) {
      series[n] += (n == 0 ? 1.0 : 2.0) / static_cast<double>(points) * strain *
                   std::cos(static_cast<double>(n) * angle);
    }
  }
  return series;
}

/// Finds the centre at which the strain has no mean: the tractions that cancel the strain then
/// vanish at both ends.
double SuperposedShift::centre_of(double half_length) const {
  const double most = 1 - half_length;
  if (most <= 0) return 0;
  return root([&](double centre) { return strain_on({centre, half_length})[0]; }, -most, most);
}

SuperposedShift::StickZone SuperposedShift::stick_zone(double force) const {
  const auto excess = [&](double half_length) {
    const double held = half_length * strain_on({centre_of(half_length), half_length})[1];
    return held - (sines_[0] - force / (scale_ * half_pi));
  };
  const double half_length = root(excess, 0, 1);
  return {.centre = centre_of(half_length), .half_length = half_length};
}

double SuperposedShift::shift(double force) const {
  if (force <= 0) return 0;
  const StickZone zone = stick_zone(force);
  const VectorXd held = strain_on(zone);
  double sum = half_pi * log_length_ * sines_[0];
  for (Index n = 0; n < sines_.size(); ++n) sum += sines_[n] * potential(n, zone.centre);
  double less = half_pi * (log_length_ - std::log(zone.half_length)) * held[1];
  for (Index n = 0; n + 1 < held.size(); ++n) less += held[n + 1] * potential(n, 0);
  return factor_ * (sum - zone.half_length * less);
}

double SuperposedShift::dissipation(double force) const {
  const auto to = [&](double f) { return shift(f); };
  return 4 * force * shift(force) - 8 * integrate(to, 0, force, 1e-10);
}

}  // namespace microslip::experiments
