// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/rough_bound.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "microslip/linalg/real_fft.hpp"
#include "microslip/support/random.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The profile at n places of its period, with a mean square of 1.
VectorXd profile(const Roughness& roughness, Index n) {
  std::mt19937_64 random(roughness.seed);
  RealFft fft(n);
  fft.spectrum().setZero();
  const Index waves = (n - 1) / 2;
  double square = 0;
  for (Index k = 1; k <= waves; ++k) {
    const double height = std::pow(static_cast<double>(k), -(roughness.hurst + 0.5));
    fft.spectrum()[k] = std::polar(height, 2 * std::numbers::pi * unit_random(random));
    square += 2 * height * height;
  }
  fft.backward();
  return fft.values() / std::sqrt(square);
}

}  // namespace

TabulatedBound rough_bound(const HertzBound& smooth, const Roughness& roughness) {
  const auto& [amplitude, hurst, seed, rows] = roughness;
  require(amplitude >= 0 && amplitude <= 10, "amplitude", amplitude, "a number in [0, 10]");
  require(hurst > 0 && hurst <= 1, "hurst", hurst, "a number in (0, 1]");
  require(rows >= 9 && rows <= 1000001, "rows", static_cast<double>(rows),
          "a whole number in [9, 1000001]");
  const double a = smooth.half_width();
  const VectorXd x = VectorXd::LinSpaced(rows, -a, a);
  const VectorXd waves = profile(roughness, rows - 1);
  VectorXd values(rows);
  for (Index i = 0; i < rows; ++i) {
    values[i] = smooth(x[i]) * std::max(0.0, 1 + amplitude * waves[i % (rows - 1)]);
  }
  return TabulatedBound(a, x, values);
}

}  // namespace microslip
