// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/spectrum/symbol.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

constexpr int reach = 600;
constexpr int order = 4;
constexpr double lowest = std::numbers::pi / 64;

}  // namespace

Symbol Symbol::of_strain(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                         double step_ratio) {
  require(step_ratio >= min_step_ratio, "step.ratio", step_ratio, "a number >= 1e-15");
  return Symbol([&](double offset) {
    return influence_difference(kernel, shape, spacing, offset, step_ratio) /
           (step_ratio * spacing);
  });
}

Symbol Symbol::of_influence(const Kernel& kernel, const ShapeFunction& shape, double spacing) {
  return Symbol([&](double offset) { return influence(kernel, shape, spacing, offset); });
}

Symbol::Symbol(const std::function<double(double)>& coefficient) {
  for (int k = -reach; k <= reach; ++k) differences_.push_back(coefficient(k));
  for (int pass = 0; pass < order; ++pass) {
    for (std::size_t i = 0; i + 1 < differences_.size(); ++i) {
      differences_[i] = differences_[i + 1] - differences_[i];
    }
    differences_.pop_back();
  }
}

std::complex<double> Symbol::operator()(double theta) const {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < differences_.size(); ++i) {
    sum += std::polar(differences_[i], (reach - static_cast<double>(i)) * theta);
  }
  return sum / std::pow(std::polar(1.0, theta) - 1.0, order);
}

Amplification::Amplification(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                             double step_ratio)
    : strain_(Symbol::of_strain(kernel, shape, spacing, step_ratio)),
      influence_(Symbol::of_influence(kernel, shape, spacing)),
      length_(step_ratio * spacing) {}

std::complex<double> Amplification::operator()(double theta) const {
  return 1.0 - length_ * strain_(theta) / influence_(theta);
}

double least_magnitude(const Symbol& symbol) {
  constexpr int samples = 64;
  constexpr int bits = 40;
  const auto magnitude = [&](double theta) { return std::abs(symbol(theta)); };
  const double width = (std::numbers::pi - lowest) / samples;
  int nearest = 0;
  for (int i = 1; i <= samples; ++i) {
    if (magnitude(lowest + i * width) < magnitude(lowest + nearest * width)) nearest = i;
  }
  const double begin = lowest + std::max(nearest - 1, 0) * width;
  const double end = lowest + std::min(nearest + 1, samples) * width;
  const double inside = boost::math::tools::brent_find_minima(magnitude, begin, end, bits).second;
  return std::min(inside, magnitude(lowest + nearest * width));
}

}  // namespace microslip
