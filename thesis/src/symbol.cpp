// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/thesis/symbol.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/gauss_points.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Elements between the kernel's singularities and the line along which coefficients are continued.
constexpr double margin = 8;
constexpr double lowest = 1e-6;
/// exp(-negligible) is next to nothing.
constexpr double negligible = 40;
/// The least magnitude is looked for from here on.
constexpr double lowest_wave = pi / 64;

/// Adds the Gauss points of panels that are at most half as long as the distance to the nearest
/// singularity: of the coefficients, at y = 0 and +-clear beside the line, and of 1/(exp(2 pi y) -
/// 1) at multiples of i.
void add_panels(double clear, std::vector<double>& heights, std::vector<double>& weights) {
  const double end = negligible / lowest;
  for (double y = 0; y < end;) {
    const double nearest = std::min(std::hypot(margin, y), std::hypot(margin, y - clear));
    const double length = std::min(std::max(1.0, y), nearest / 2);
    for_gauss_points<15>(y, y + length, [&](double height, double weight) {
      heights.push_back(height);
      weights.push_back(weight);
    });
    y += length;
  }
}

/// (A - A')/(c dx) at a complex distance from the node: the kernel's decay, integrated with the
/// shape and its mean over the step. All lengths are in units of dx.
/// \param direction  1 ahead of the node, -1 behind it
template <class K>
Complex continued(const K& kernel, const ShapeFunction& shape, double spacing, double step_ratio,
                  Complex distance, double direction) {
  using boost::math::quadrature::gauss;
  constexpr double longest = 2;
  const double parts = std::ceil(step_ratio / longest);
  const auto stepped = [&](Complex from) {
    Complex sum = 0;
    for (double k = 0; k < parts; ++k) {
      const auto decay = [&](double part) {
        return kernel.decay(spacing * (from + direction * step_ratio * (k + part) / parts));
      };
      sum += gauss<double, 7>::integrate(decay, 0.0, 1.0);
    }
    return sum / parts;
  };
  Complex sum = 0;
  for (const ShapeFunction::Piece& piece : shape.pieces()) {
    const auto weighted = [&](double s) {
      return (piece.c[0] + s * (piece.c[1] + s * piece.c[2])) * stepped(distance - direction * s);
    };
    sum += gauss<double, 7>::integrate(weighted, piece.begin, piece.end);
  }
  return direction * spacing * sum;
}

}  // namespace

Symbol Symbol::of_strain(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                         double step_ratio) {
  require_step_ratio(step_ratio);
  return {kernel, shape, spacing, step_ratio};
}

/// A step of one element takes the displacements of the next node: A - A' = A (1 - exp(i theta)).
Symbol Symbol::of_influence(const Kernel& kernel, const ShapeFunction& shape, double spacing) {
  Symbol symbol(kernel, shape, spacing, 1);
  symbol.influence_spacing_ = spacing;
  return symbol;
}

Symbol::Symbol(const Kernel& kernel, const ShapeFunction& shape, double spacing,
               double step_ratio) {
  const double reach = std::max(-shape.breakpoints().front(), shape.breakpoints().back());
  first_ = static_cast<int>(std::ceil(reach + step_ratio + margin));
  const auto coefficient = [&](int k) {
    return influence_difference(kernel, shape, spacing, k, step_ratio) / (step_ratio * spacing);
  };
  for (int k = 1 - first_; k < first_; ++k) near_.push_back(coefficient(k));
  add_panels(kernel.clear_distance() / spacing, heights_, weights_);
  ahead_.first = coefficient(first_);
  behind_.first = coefficient(-first_);
  for (const double y : heights_) {
    const auto at = [&](double direction) {
      return visit_half_space(
          [&](const auto& k) {
            return continued(k, shape, spacing, step_ratio, Complex(static_cast<double>(first_), y),
                             direction);
          },
          kernel);
    };
    ahead_.values.push_back(at(1));
    behind_.values.push_back(at(-1));
  }
}

/// Sum of coefficients times exp(i k theta) from k = first_ on, by Abel and Plana. Both
/// exponentials that grow are divided by exp(2 pi y) at once.
Complex Symbol::sum(const Side& side, double theta) const {
  Complex integral = 0;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const double y = heights_[i];
    if (y * theta > negligible) break;
    const double occupied = -1 / std::expm1(-2 * pi * y);
    const double growing = std::exp(-(2 * pi - theta) * y) * occupied;
    const double twice_sinh = -std::expm1(-2 * theta * y) * growing;
    const double twice_cosh = (1 + std::exp(-2 * theta * y)) * growing;
    const Complex value = side.values[i];
    integral += weights_[i] * (value * std::exp(-theta * y) +
                               Complex(-value.real() * twice_sinh, value.imag() * twice_cosh));
  }
  return std::polar(1.0, first_ * theta) * (side.first / 2 + Complex(0, 1) * integral);
}

Complex Symbol::operator()(double theta) const {
  Complex all = std::conj(sum(ahead_, theta)) + sum(behind_, theta);
  for (std::size_t i = 0; i < near_.size(); ++i) {
    all += std::polar(near_[i], (first_ - 1 - static_cast<double>(i)) * theta);
  }
  if (influence_spacing_ == 0) return all;
  return all * influence_spacing_ /
         -Complex(-2 * std::pow(std::sin(theta / 2), 2), std::sin(theta));
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
  const double width = (std::numbers::pi - lowest_wave) / samples;
  int nearest = 0;
  for (int i = 1; i <= samples; ++i) {
    if (magnitude(lowest_wave + i * width) < magnitude(lowest_wave + nearest * width)) nearest = i;
  }
  const double begin = lowest_wave + std::max(nearest - 1, 0) * width;
  const double end = lowest_wave + std::min(nearest + 1, samples) * width;
  const double inside = boost::math::tools::brent_find_minima(magnitude, begin, end, bits).second;
  return std::min(inside, magnitude(lowest_wave + nearest * width));
}

}  // namespace microslip
