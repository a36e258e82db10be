// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/traction_bound.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/sine.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

HertzBound::HertzBound(double half_width, double peak) : half_width_(half_width), peak_(peak) {
  require_positive("half_width", half_width);
  require_positive("peak_traction", peak);
}

double HertzBound::operator()(double x) const {
  return peak_ * height(half_width_ + x, half_width_ - x);
}

/// g / peak, at distances from the edges
double HertzBound::height(double to_trailing, double to_leading) const {
  return std::sqrt(std::max(0.0, to_trailing / half_width_ * (to_leading / half_width_)));
}

/// The integral from the heights at both ends: the trapezium under a chord of the unit circle plus
/// the segment beyond the chord.
double HertzBound::integral(double heights, double length) const {
  const double width = length / half_width_;
  return half_width_ * peak_ / 2 * (heights * width + x_minus_sine(2 * std::atan2(width, heights)));
}

double HertzBound::integral(double x) const {
  if (x <= -half_width_) return 0;
  if (x >= half_width_) return total();
  return integral(height(half_width_ + x, half_width_ - x), half_width_ + x);
}

double HertzBound::mean_around(double x, double width) const {
  const double to_trailing = half_width_ + x;
  const double to_leading = half_width_ - x;
  const double behind = std::min(width / 2, to_trailing);
  const double before = std::min(width / 2, to_leading);
  if (behind + before <= 0) return 0;
  const double heights = height(to_trailing - behind, to_leading + behind) +
                         height(to_trailing + before, to_leading - before);
  return integral(heights, behind + before) / width;
}

double HertzBound::total() const { return std::numbers::pi / 2 * half_width_ * peak_; }

namespace {

/// h(t) as a sum of Chebyshev's polynomials of the second kind, by discrete projection, which is
/// exact.
VectorXd second_kind(const VectorXd& coefficients) {
  const Index count = coefficients.size();
  const double step = std::numbers::pi / static_cast<double>(count + 1);
  VectorXd series = VectorXd::Zero(count);
  for (Index j = 1; j <= count; ++j) {
    const double angle = static_cast<double>(j) * step;
    double h = 0;
    for (Index k = count - 1; k >= 0; --k) h = h * std::cos(angle) + coefficients[k];
    for (Index n = 0; n < count; ++n) {
      series[n] += 2 / static_cast<double>(count + 1) * h * std::sin(angle) *
                   std::sin(static_cast<double>(n + 1) * angle);
    }
  }
  return series;
}

ChebyshevTraction polynomial_traction(double half_width, double peak,
                                      const VectorXd& coefficients) {
  constexpr Index most = 33;
  constexpr int samples = 1000;
  require_positive("half_width", half_width);
  require_positive("peak_traction", peak);
  const auto count = static_cast<double>(coefficients.size());
  require(coefficients.size() >= 1 && coefficients.size() <= most, "coefficients", count,
          "1 to 33 coefficients");
  for (const double c : coefficients) {
    require(true, "coefficients", c, "finite coefficients");
  }
  const double size = coefficients.lpNorm<1>();
  require(size > 0, "coefficients", size, "coefficients that are not all zero");
  require_positive("sum of the sizes of coefficients", size);
  ChebyshevTraction traction(-half_width, half_width, peak * second_kind(coefficients));
  double least = HUGE_VAL;
  for (int i = 0; i <= samples; ++i) {
    least = std::min(least, traction.polynomial(half_width * (2.0 * i / samples - 1)) / peak);
  }
  require(least >= -1e-12 * size, "least value of coefficients", least, "none below zero");
  return traction;
}

}  // namespace

PolynomialBound::PolynomialBound(double half_width, double peak, const VectorXd& coefficients)
    : traction_(polynomial_traction(half_width, peak, coefficients)) {}

double PolynomialBound::mean_around(double x, double width) const {
  const double behind = std::min(width / 2, half_width() + x);
  const double before = std::min(width / 2, half_width() - x);
  if (behind + before <= 0) return 0;
  return std::max(0.0, traction_.integral(x, behind, before)) / width;
}

std::optional<ChebyshevTraction> chebyshev_traction(const TractionBound& bound) {
  if (const auto* hertz = std::get_if<HertzBound>(&bound)) {
    return ChebyshevTraction(-hertz->half_width(), hertz->half_width(),
                             VectorXd::Constant(1, hertz->peak()));
  }
  if (const auto* polynomial = std::get_if<PolynomialBound>(&bound)) return polynomial->traction();
  return std::nullopt;
}

namespace {

/// Moves a position to the edge if it differs by rounding only: positions and half-widths may have
/// been converted from other units, each with its own rounding error. Beyond the edge there is
/// nothing but it, so that a position there may also have been printed with seven digits.
double at_edge_if_near(double x, double half_width) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  constexpr double printed = 1e-6;
  const double beyond = std::abs(x) / half_width - 1;
  return beyond >= -rounding && beyond <= printed ? std::copysign(half_width, x) : x;
}

}  // namespace

TabulatedBound::TabulatedBound(double half_width, const VectorXd& x, const VectorXd& values)
    : half_width_(half_width), x_(x.size() + 2), values_(x.size() + 2) {
  require_positive("half_width", half_width);
  if (x.size() == 0) throw std::invalid_argument("0 rows: expected at least one");
  for (Index i = 0; i < x.size(); ++i) {
    require(std::abs(at_edge_if_near(x[i], half_width)) <= half_width, "x", x[i], [&] {
      return fmt::format("positions from -{0} to {0}, the half-width", format_short(half_width));
    });
    require(i == 0 || x[i] > x[i - 1], "x", x[i], "ascending positions");
    require(i == 0 || std::min(x[i], half_width) > std::max(x[i - 1], -half_width), "x", x[i],
            "one row at an edge");
    require(values[i] >= 0, "bound", values[i], "a number >= 0");
  }
  require(values.maxCoeff() > 0, "bound", 0, "a bound that is not zero everywhere");
  require_positive("largest of bound", values.maxCoeff());
  const Index last = x.size() - 1;
  const double first_x = at_edge_if_near(x[0], half_width);
  const double last_x = at_edge_if_near(x[last], half_width);
  x_ << -half_width, x, half_width;
  x_[1] = first_x;
  x_[last + 1] = last_x;
  values_ << (first_x > -half_width ? 0 : values[0]), values,
      (last_x < half_width ? 0 : values[last]);
  integrate();
}

double TabulatedBound::operator()(double x) const {
  if (std::abs(x) > half_width_) return 0;
  const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const Index i = after - x_.begin();
  const double width = x_[i] - x_[i - 1];
  if (width <= 0) return values_[i];
  return ((x_[i] - x) * values_[i - 1] + (x - x_[i - 1]) * values_[i]) / width;
}

double TabulatedBound::integral(double x) const {
  if (x <= x_[0]) return 0;
  const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const Index i = after - x_.begin();
  if (x >= x_[i]) return integrals_[i];
  return integrals_[i - 1] + (x - x_[i - 1]) * (values_[i - 1] + (*this)(x)) / 2;
}

void TabulatedBound::integrate() {
  integrals_ = VectorXd::Zero(x_.size());
  for (Index i = 1; i < x_.size(); ++i) {
    integrals_[i] = integrals_[i - 1] + (x_[i] - x_[i - 1]) * (values_[i - 1] + values_[i]) / 2;
  }
}

double TabulatedBound::mean_around(double x, double width) const {
  double sum = 0;
  const auto first = std::upper_bound(x_.begin() + 1, x_.end() - 1, x - width / 2);
  for (Index i = first - x_.begin(); i < x_.size(); ++i) {
    // Positions are relative to x, because the width may be tiny compared to x.
    const double begin = std::max(x_[i - 1] - x, -width / 2);
    const double end = std::min(x_[i] - x, width / 2);
    if (begin >= width / 2) break;
    if (begin >= end) continue;
    const double middle = (begin + end) / 2;
    const double value =
        ((x_[i] - x - middle) * values_[i - 1] + (x - x_[i - 1] + middle) * values_[i]) /
        (x_[i] - x_[i - 1]);
    sum += (end - begin) * value;
  }
  return sum / width;
}

double half_width_of(const TractionBound& bound) {
  return std::visit([](const auto& b) { return b.half_width(); }, bound);
}

VectorXd bound_at(const TractionBound& bound, const VectorXd& x) {
  const auto values = [&](const auto& b) -> VectorXd {
    return x.unaryExpr([&](double xi) { return b(xi); });
  };
  return std::visit(values, bound);
}

VectorXd mean_bound_around(const TractionBound& bound, const VectorXd& x, double width) {
  const auto values = [&](const auto& b) -> VectorXd {
    return x.unaryExpr([&](double xi) { return b.mean_around(xi, width); });
  };
  return std::visit(values, bound);
}

VectorXd element_means(const TractionBound& bound, const VectorXd& x, const VectorXd& lengths) {
  const Index last = x.size() - 1;
  VectorXd means(x.size());
  double before = 0;
  const auto integral = [&](double end) {
    return std::visit([&](const auto& g) { return g.integral(end); }, bound);
  };
  for (Index i = 0; i <= last; ++i) {
    const double after = i == last ? full_sliding_force(bound) : integral(x[i] + lengths[i] / 2);
    means[i] = std::max(0.0, after - before) / lengths[i];
    before = after;
  }
  return means;
}

double full_sliding_force(const TractionBound& bound) {
  return std::visit([](const auto& b) { return b.total(); }, bound);
}

}  // namespace microslip
