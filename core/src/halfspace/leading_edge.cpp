// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/leading_edge.hpp"

#include <algorithm>
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

// V(theta) - 1. At small theta the term m = 0 of the lattice sum is 1 to second order, and the
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

/// The mean over (0, pi). With a layer the integrand bends at theta = 1/softness, which panels are
/// graded towards.
/// \param integrand  of theta
template <class Integrand>
double mean_over(double softness, const Integrand& integrand) {
  using boost::math::quadrature::gauss;
  if (softness == 0) return gauss<double, 60>::integrate(integrand, 0.0, pi) / pi;
  const double shortest = 1e-3 * std::min(1.0, 1 / softness);
  double sum = 0;
  double end = pi;
  for (; end > shortest; end /= 2) sum += gauss<double, 15>::integrate(integrand, end / 2, end);
  return (sum + gauss<double, 15>::integrate(integrand, 0.0, end)) / pi;
}

/// 2 softness sin(theta/2) / V
double layer_over(double softness, double theta, double b) {
  return 2 * softness * std::sin(theta / 2) / b;
}

/// A layer adds this to the offset: 1/pi times the integral over theta > 0 of ln(1 + softness
/// theta) / theta^2, less that up to pi of ln(1 + layer_over) / (2 sin(theta/2))^2. Close to 0,
/// where either is infinite, their difference is formed.
double offset_by_layer(const std::function<double(double)>& b_less_one, double softness) {
  const double exact_beyond_pi =
      (std::log1p(softness * pi) / pi + softness * std::log1p(1 / (softness * pi))) / pi;
  return exact_beyond_pi - mean_over(softness, [&](double theta) {
           const double less = sinc_less_one(theta / 2);
           const double b = b_less_one(theta);
           const double exact = std::log1p(softness * theta);
           const double change = softness * theta * (less - b) / (1 + b) / (1 + softness * theta);
           return (exact * power_less_one(less, -2) + std::log1p(change) / std::pow(1 + less, 2)) /
                  (theta * theta);
         });
}

LeadingEdgeConstants integrated(const std::function<double(double)>& b_less_one, double softness) {
  const auto mean = [&](double soft, const std::function<double(double)>& factor) {
    return mean_over(soft, [&](double theta) {
      const double b = b_less_one(theta);
      return (std::log1p(b) + std::log1p(layer_over(soft, theta, 1 + b))) * factor(theta);
    });
  };
  LeadingEdgeConstants edge{
      .offset = 0.75 - mean(0, [](double theta) { return std::pow(std::sin(theta / 2), -2); }) / 4,
      .compliance = std::exp(mean(softness, [](double) { return 1.0; })) / (1 + softness),
      .second = 0,
      .layer = {}};
  if (softness > 0) edge.offset += offset_by_layer(b_less_one, softness);
  // The generating function of the nodes' values is (1 - z)^(-3/2) / b+(z), where ln b+ has the
  // Fourier coefficients of ln b. The values grow as 2/sqrt(pi) sqrt(e0) sqrt(j).
  std::array<double, edge.layer.size()> fourier{};
  std::array<double, edge.layer.size()> reciprocal{1};
  std::array<double, edge.layer.size()> growth{1};
  for (std::size_t k = 1; k < edge.layer.size(); ++k) {
    const auto order = static_cast<double>(k);
    fourier[k] = mean(softness, [&](double theta) { return std::cos(order * theta); });
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
  edge.second =
      edge.layer[1] * std::sqrt(1 + edge.offset) / (edge.layer[0] * std::sqrt(edge.offset));
  return edge;
}

/// Springs alone: tractions are linear from the edge on.
LeadingEdgeConstants of_springs() {
  LeadingEdgeConstants edge{.offset = 1, .compliance = 1, .second = 2, .layer = {}};
  edge.layer.fill(1);
  return edge;
}

/// Above this softness the layer acts as springs alone, to rounding.
constexpr double softest = 1e15;

LeadingEdgeConstants with_layer(const std::function<double(double)>& b_less_one, double softness) {
  const LeadingEdgeConstants alone = integrated(b_less_one, 0);
  if (softness == 0) return alone;
  if (softness > softest) return of_springs();
  LeadingEdgeConstants edge = integrated(b_less_one, softness);
  const double part = (1 - edge.offset) / (1 - alone.offset);
  for (std::size_t k = 0; k < edge.layer.size(); ++k) {
    edge.layer[k] = 1 + part * (alone.layer[k] - 1);
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

double softness(const Kernel& kernel, double spacing) {
  const double compliance = kernel.layer_compliance();
  return compliance == 0 ? 0 : compliance / (pi * kernel.log_factor() * spacing);
}

LeadingEdgeConstants leading_edge_constants(const Basis& basis, double softness) {
  if (basis.has_only(constant_shape())) return with_layer(constant_less_one, softness);
  if (basis.has_only(linear_shape())) return with_layer(linear_less_one, softness);
  reject("basis", basis.name(), "constant or linear");
}

}  // namespace microslip
