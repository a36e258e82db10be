// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/full_sliding.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "microslip/support/chebyshev_series.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;

PolygonField::PolygonField(const Kernel& kernel, const TabulatedBound& bound)
    : kernel_(kernel), bound_(bound) {}

double PolygonField::strain(double x) const {
  count_work(2 * kernel_work * static_cast<double>(bound_.x().size()));
  // By parts: the kernel acts on the slopes, and on the jumps at the edges.
  const Eigen::VectorXd& ends = bound_.x();
  const Eigen::VectorXd& values = bound_.values();
  const auto sum = [&](const auto& kernel) {
    double slope_of_u = 0;
    for (Index i = 1; i < ends.size(); ++i) {
      const double width = ends[i] - ends[i - 1];
      if (width <= 0 || values[i] == values[i - 1]) continue;
      slope_of_u += (values[i] - values[i - 1]) / width *
                    (kernel.integral(x - ends[i - 1]) - kernel.integral(x - ends[i]));
    }
    const double first = values[0];
    const double last = values[values.size() - 1];
    if (first != 0) slope_of_u += first * kernel.displacement(std::abs(x - ends[0]));
    if (last != 0) slope_of_u -= last * kernel.displacement(std::abs(x - ends[ends.size() - 1]));
    return -slope_of_u;
  };
  return std::visit(sum, kernel_);
}

double PolygonField::displacement(double x) const {
  count_work(2 * kernel_work * static_cast<double>(bound_.x().size()));
  const Eigen::VectorXd& ends = bound_.x();
  const Eigen::VectorXd& values = bound_.values();
  const auto sum = [&](const auto& kernel) {
    double u = values[0] * kernel.integral(x - ends[0]) -
               values[values.size() - 1] * kernel.integral(x - ends[ends.size() - 1]);
    for (Index i = 1; i < ends.size(); ++i) {
      const double width = ends[i] - ends[i - 1];
      if (width <= 0) continue;
      u += (values[i] - values[i - 1]) / width *
           (kernel.double_integral(x - ends[i - 1]) - kernel.double_integral(x - ends[i]));
    }
    return u;
  };
  return std::visit(sum, kernel_);
}

namespace {

/// Up to this part of the half-width a difference of displacements is the integral of the strain.
constexpr double small_shift = 1e-3;

std::variant<ChebyshevField, PolygonField> field_of(const Kernel& kernel,
                                                    const TractionBound& bound) {
  if (const auto smooth = chebyshev_traction(bound)) return ChebyshevField(kernel, *smooth);
  return PolygonField(kernel, std::get<TabulatedBound>(bound));
}

}  // namespace

FullSliding::FullSliding(const Kernel& kernel, const TractionBound& bound)
    : force_(full_sliding_force(bound)),
      half_width_(half_width_of(bound)),
      clear_distance_(clear_distance(kernel)),
      field_(field_of(kernel, bound)) {}

double FullSliding::strain(double x) const {
  if (const auto* smooth = std::get_if<ChebyshevField>(&field_)) {
    return x > -half_width_ ? smooth->continued_strain(x) : smooth->strain(x);
  }
  return std::get<PolygonField>(field_).strain(x);
}

/// It is analytic within the clear distance, which determines how fast a series converges.
Eigen::VectorXd FullSliding::strain(const Eigen::VectorXd& x) const {
  const auto at = [this](double xi) { return strain(xi); };
  const auto* smooth = std::get_if<ChebyshevField>(&field_);
  const double last = x[x.size() - 1];
  const double relative = 2 * clear_distance_ / (last - x[0]);
  const double digits = 34 / std::asinh(relative);  // ln 1e-15 = -34.5
  const double terms =
      smooth ? digits + static_cast<double>(smooth->traction().coefficients().size()) : 0;
  const bool pays =
      smooth && std::isfinite(clear_distance_) && 4 * terms < static_cast<double>(x.size());
  if (!pays) return x.unaryExpr(at);
  return x.unaryExpr(ChebyshevSeries(at, x[0], last, static_cast<std::size_t>(terms)));
}

double FullSliding::displacement(double x) const {
  if (const auto* smooth = std::get_if<ChebyshevField>(&field_)) {
    return x > -half_width_ ? smooth->continued_displacement(x) : smooth->displacement(x);
  }
  return std::get<PolygonField>(field_).displacement(x);
}

double FullSliding::difference(double x, double shift) const {
  if (shift > small_shift * half_width_) return displacement(x) - displacement(x + shift);
  using boost::math::quadrature::gauss;
  // Behind the contact the strain is a series in the root of the distance from the trailing edge.
  const double farthest = std::max(0.0, -half_width_ - x);
  const double behind = std::min(farthest, shift);
  const double nearest = std::sqrt(farthest - behind);
  const double range = behind > 0 ? behind / (std::sqrt(farthest) + nearest) : 0;
  const auto at_root = [&](double s) {
    const double root = nearest + s * range;
    return 2 * root * strain(-half_width_ - root * root);
  };
  const auto after = [&](double s) { return strain(x + behind + s * (shift - behind)); };
  return (range > 0 ? range * gauss<double, 7>::integrate(at_root, 0.0, 1.0) : 0) +
         (behind < shift ? (shift - behind) * gauss<double, 7>::integrate(after, 0.0, 1.0) : 0);
}

}  // namespace microslip
