// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/full_sliding.hpp"

#include <cmath>
#include <stdexcept>

#include "microslip/support/chebyshev_series.hpp"

namespace microslip {

namespace {

ChebyshevField field_of(const Kernel& kernel, const TractionBound& bound) {
  const auto smooth = chebyshev_traction(bound);
  if (!smooth) throw std::invalid_argument("bound: expected a smooth one, not a table");
  return ChebyshevField(kernel, *smooth);
}

}  // namespace

FullSliding::FullSliding(const Kernel& kernel, const TractionBound& bound)
    : force_(full_sliding_force(bound)),
      half_width_(half_width_of(bound)),
      clear_distance_(clear_distance(kernel)),
      field_(field_of(kernel, bound)) {}

double FullSliding::strain(double x) const {
  return x > -half_width_ ? field_.continued_strain(x) : field_.strain(x);
}

/// It is analytic within the clear distance, which determines how fast a series converges.
Eigen::VectorXd FullSliding::strain(const Eigen::VectorXd& x) const {
  const auto at = [this](double xi) { return strain(xi); };
  const double last = x[x.size() - 1];
  const double relative = 2 * clear_distance_ / (last - x[0]);
  const double digits = 34 / std::asinh(relative);  // ln 1e-15 = -34.5
  const double terms = digits + static_cast<double>(field_.traction().coefficients().size());
  const bool pays =
      last > x[0] && std::isfinite(clear_distance_) && 4 * terms < static_cast<double>(x.size());
  if (!pays) return x.unaryExpr(at);
  return x.unaryExpr(ChebyshevSeries(at, x[0], last, static_cast<std::size_t>(terms)));
}

double FullSliding::displacement(double x) const {
  return x > -half_width_ ? field_.continued_displacement(x) : field_.displacement(x);
}

}  // namespace microslip
