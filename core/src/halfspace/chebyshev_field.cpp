// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/chebyshev_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double narrowest = 0.02;

/// Sum of c_n f_(n+1), f_k following Chebyshev's recurrence from 1 and t: f_k = T_k(t).
double strain_series(const VectorXd& c, double t) {
  count_work(5 * static_cast<double>(c.size()));
  double before = 1;
  double now = t;
  double sum = 0;
  for (Index n = 0; n < c.size(); ++n) {
    sum += c[n] * now;
    before = std::exchange(now, 2 * t * now - before);
  }
  return sum;
}

/// The same with f_k = r^k.
double power_series(const VectorXd& c, double r) {
  double sum = 0;
  for (Index n = c.size() - 1; n >= 0; --n) sum = r * (c[n] + sum);
  return sum;
}

/// Antiderivative of the strain series, (f_(n+2)/(n+2) - f_n/n)/2 term by term; for n = 0 without
/// the second term.
template <class Values>
double antiderivative(const VectorXd& c, const Values& f) {
  count_work(8 * static_cast<double>(c.size()));
  double sum = c[0] * f(2) / 4;
  for (Index n = 1; n < c.size(); ++n) {
    const auto k = static_cast<double>(n);
    sum += c[n] * (f(n + 2) / (k + 2) - f(n) / k) / 2;
  }
  return sum;
}

/// 1 / |r| - 1 outside [-1, 1], where T_k(t) becomes r^k.
/// \param beyond  |t| - 1
double growth(double beyond) { return beyond + std::sqrt(beyond * (2 + beyond)); }

VectorXd chebyshev_values(double t, Index size) {
  VectorXd values(size);
  values[0] = 1;
  values[1] = t;
  for (Index k = 2; k < size; ++k) values[k] = 2 * t * values[k - 1] - values[k - 2];
  return values;
}

}  // namespace

ChebyshevField::ChebyshevField(const Kernel& kernel, const ChebyshevTraction& traction)
    : kernel_(kernel), traction_(traction), log_strain_(kernel.log_factor() * std::numbers::pi) {
  require_half_space(kernel, "Chebyshev collocation");
  const double clear = kernel.clear_distance() / traction.half_length();
  Index count = traction.coefficients().size();
  if (std::isfinite(clear)) {
    require(2 * clear >= narrowest, "width", 2 * kernel.clear_distance(),
            "at least 0.02 half-widths of the contact, or the scheme standard");
    count += static_cast<Index>(20 + 20 / clear);
  }
  points_.resize(count);
  line_loads_.resize(count);
  const double step = std::numbers::pi / static_cast<double>(count + 1);
  for (Index j = 0; j < count; ++j) {
    const double angle = static_cast<double>(j + 1) * step;
    points_[j] = traction.centre() + traction.half_length() * std::cos(angle);
    line_loads_[j] = traction.half_length() * step * std::sin(angle) * std::sin(angle) *
                     traction.polynomial(points_[j]);
  }
}

/// \param part  function of the distance: a part of the kernel
template <class Part>
double ChebyshevField::integrate(double x, const Part& part) const {
  count_work(kernel_work * static_cast<double>(points_.size()));
  const auto sum = [&](const auto& kernel) {
    double integral = 0;
    for (Index j = 0; j < points_.size(); ++j) {
      integral += line_loads_[j] * part(kernel, x - points_[j]);
    }
    return integral;
  };
  return visit_half_space(sum, kernel_);
}

double ChebyshevField::regular_strain(double x) const {
  return integrate(x, [](const auto& kernel, double z) { return kernel.regular_decay(z); });
}

double ChebyshevField::regular_displacement(double x) const {
  return integrate(x, [](const auto& kernel, double z) { return kernel.regular_displacement(z); });
}

double ChebyshevField::continued_strain(double x) const {
  return log_strain_ * strain_series(traction_.coefficients(), position(x)) + regular_strain(x);
}

/// Distance from the nearer end over the half-length, computed from that end, so that the distance
/// keeps its digits.
double ChebyshevField::beyond_ends(double x) const {
  return std::max(traction_.begin() - x, x - traction_.end()) / traction_.half_length();
}

double ChebyshevField::strain(double x) const {
  const double beyond = beyond_ends(x);
  if (beyond <= 0) return continued_strain(x);
  const double r = std::copysign(1 / (1 + growth(beyond)), position(x));
  return log_strain_ * power_series(traction_.coefficients(), r) + regular_strain(x);
}

double ChebyshevField::continued_displacement(double x) const {
  const VectorXd& c = traction_.coefficients();
  const VectorXd values = chebyshev_values(position(x), c.size() + 2);
  // The logarithm for an interval of half-length 1, at its centre, scaled to the half-length of
  // this interval.
  const double logarithms = c[0] * (std::numbers::ln2 - std::log(traction_.half_length())) / 2;
  return -log_strain_ * traction_.half_length() *
             (antiderivative(c, [&](Index k) { return values[k]; }) - logarithms) +
         regular_displacement(x);
}

double ChebyshevField::displacement(double x) const {
  const double beyond = beyond_ends(x);
  if (beyond <= 0) return continued_displacement(x);
  const VectorXd& c = traction_.coefficients();
  const double r = std::copysign(1 / (1 + growth(beyond)), position(x));
  const double logarithms =
      c[0] * (std::numbers::ln2 - std::log(traction_.half_length()) - std::log1p(growth(beyond))) /
      2;
  return -log_strain_ * traction_.half_length() *
             (antiderivative(c, [&](Index k) { return std::pow(r, static_cast<double>(k)); }) -
              logarithms) +
         regular_displacement(x);
}

}  // namespace microslip
