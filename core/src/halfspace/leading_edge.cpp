// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/leading_edge.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "microslip/support/require.hpp"
#include "microslip/support/sine.hpp"

namespace microslip {

namespace {

using std::numbers::pi;

/// sin(x)/x - 1
double sinc_less_one(double x) { return x == 0 ? 0 : -x_minus_sine(x) / x; }

/// (1 + y)^n - 1
double power_less_one(double y, int n) { return std::expm1(n * std::log1p(y)); }

// b(theta) - 1. At small theta the term m = 0 of the lattice sum is 1 to second order, and the
// other terms vanish to the same order. These other terms are tri- and tetragamma functions of z =
// theta/(2 pi).

double constant_less_one(double theta) {
  using boost::math::trigamma;
  const double z = theta / (2 * pi);
  const double s = std::sin(theta / 2);
  const double others =
      trigamma(z / 2 + 1) - trigamma((z + 1) / 2) + trigamma((1 - z) / 2) - trigamma(1 - z / 2);
  return power_less_one(sinc_less_one(theta / 2), 2) + s * s / (4 * pi * pi) * others;
}

double linear_less_one(double theta) {
  const auto tetragamma = [](double x) { return boost::math::polygamma(2, x); };
  const double z = theta / (2 * pi);
  const double s = std::sin(theta / 2) / pi;
  const double others = -(tetragamma(1 + z) + tetragamma(1 - z)) / 2;
  return power_less_one(sinc_less_one(theta / 2), 3) + s * s * s * others;
}

LeadingEdgeConstants integrated(const std::function<double(double)>& b_less_one) {
  using boost::math::quadrature::gauss;
  const auto mean = [&](const std::function<double(double)>& factor) {
    const auto integrand = [&](double theta) {
      return std::log1p(b_less_one(theta)) * factor(theta);
    };
    return gauss<double, 60>::integrate(integrand, 0.0, pi) / pi;
  };
  LeadingEdgeConstants edge{
      .offset = 0.75 - mean([](double theta) { return std::pow(std::sin(theta / 2), -2); }) / 4,
      .compliance = std::exp(mean([](double) { return 1.0; })),
      .layer = {}};
  // The generating function of the nodes' values is (1 - z)^(-3/2) / b+(z), where ln b+ has the
  // Fourier coefficients of ln b. The values grow as 2/sqrt(pi) sqrt(e0) sqrt(j).
  std::array<double, edge.layer.size()> fourier{};
  std::array<double, edge.layer.size()> reciprocal{1};
  std::array<double, edge.layer.size()> growth{1};
  for (std::size_t k = 1; k < edge.layer.size(); ++k) {
    const auto order = static_cast<double>(k);
    fourier[k] = mean([&](double theta) { return std::cos(order * theta); });
    for (std::size_t i = 1; i <= k; ++i) {
      reciprocal[k] -= static_cast<double>(i) / order * fourier[i] * reciprocal[k - i];
    }
    growth[k] = growth[k - 1] * (order + 0.5) / order;
  }
  for (std::size_t k = 0; k < edge.layer.size(); ++k) {
    double value = 0;
    for (std::size_t i = 0; i <= k; ++i) value += growth[i] * reciprocal[k - i];
    edge.layer[k] = value / (2 / std::sqrt(pi) * std::sqrt(edge.compliance) *
                             std::sqrt(static_cast<double>(k) + edge.offset));
  }
  return edge;
}

}  // namespace

double LeadingEdgeConstants::value(Eigen::Index j, double fraction) const {
  if (j + 1 >= static_cast<Eigen::Index>(layer.size())) return 1;
  const auto node = static_cast<double>(j);
  const auto value = [&](Eigen::Index i) {
    return i < 0 ? 0
                 : layer[static_cast<std::size_t>(i)] * std::sqrt(static_cast<double>(i) + offset);
  };
  return ((1 - fraction) * value(j) + fraction * value(j + 1)) /
         std::sqrt(node + offset + fraction);
}

LeadingEdgeConstants leading_edge_constants(const Basis& basis) {
  if (basis.name() == "constant") return integrated(constant_less_one);
  if (basis.name() == "linear") return integrated(linear_less_one);
  reject("basis", basis.name(), "constant or linear");
}

}  // namespace microslip
