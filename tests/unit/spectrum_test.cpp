// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <complex>
#include <numbers>

#include "microslip/halfspace/influence.hpp"
#include "microslip/thesis/fourier_inverse.hpp"
#include "microslip/thesis/symbol.hpp"

namespace microslip::spectrum_test {

constexpr Material material{1, 0.28};

Symbol symbol_of(const ShapeFunction& shape, double step_ratio) {
  return Symbol::of_strain(PlaneKernel(material, 1), shape, 1, step_ratio);
}

// c = 1, constant functions, plane strain: at the highest frequency the aliases sum to 8 G / pi^2,
// with Catalan's constant G.
TEST(Symbol, AgreesWithItsClosedFormAtTheHighestFrequency) {
  const double exact =
      8 * boost::math::constants::catalan<double>() / (std::numbers::pi * std::numbers::pi);
  const std::complex<double> value = symbol_of(constant_shape(), 1)(std::numbers::pi);
  EXPECT_NEAR(value.real() / compliance(material), exact, 1e-10);
  EXPECT_NEAR(value.imag(), 0, 1e-10);
}

// Sum over aliases of K^(xi) shape^(xi) (1 - exp(i xi c)) / c, with K^ = 1/|xi| in plane strain.
TEST(Symbol, AgreesWithTheSumOverAliases) {
  const double c = 0.3;
  for (const double theta : {std::numbers::pi / 64, std::numbers::pi / 16, 1.0, 2.5}) {
    std::complex<double> exact = 0;
    for (int m = -40000; m <= 40000; ++m) {
      const double xi = theta + 2 * std::numbers::pi * m;
      const double hat = std::pow(2 * std::sin(xi / 2) / xi, 2);
      exact += hat / std::abs(xi) * (1.0 - std::polar(1.0, xi * c)) / c;
    }
    const std::complex<double> value = symbol_of(linear_shape(), c)(theta) / compliance(material);
    EXPECT_LT(std::abs(value - exact), theta < 0.1 ? 1e-6 : 1e-9) << theta;
  }
}

// Computed independently.
TEST(Symbol, LeastMagnitudes) {
  const auto least = [](const ShapeFunction& shape, double c) {
    return least_magnitude(symbol_of(shape, c)) / compliance(material);
  };
  EXPECT_NEAR(least(constant_shape(), 1), 0.742, 5e-4);
  EXPECT_NEAR(least(constant_shape(), 0.2), 0.207, 5e-4);
  EXPECT_NEAR(least(constant_shape(), 0.01), 0.010, 5e-4);
  EXPECT_NEAR(least(linear_shape(), 1), 0.543, 5e-4);
  EXPECT_NEAR(least(linear_shape(), 0.2), 0.338, 5e-4);
  EXPECT_NEAR(least(linear_shape(), 0.01), 0.036, 5e-4);
}

/// Sums over aliases of K^(xi) shape^(xi) exp(i xi c) for constant functions, with K^ = 1/|xi|.
std::complex<double> influence_sum(double theta, double c) {
  std::complex<double> sum = 0;
  for (int m = -400000; m <= 400000; ++m) {
    const double xi = theta + 2 * std::numbers::pi * m;
    sum += 2 * std::sin(xi / 2) / (xi * std::abs(xi)) * std::polar(1.0, xi * c);
  }
  return sum;
}

TEST(Symbol, OfTheInfluenceAgreesWithTheSumOverAliases) {
  const Symbol symbol = Symbol::of_influence(PlaneKernel(material, 1), constant_shape(), 1);
  for (const double theta : {std::numbers::pi / 64, std::numbers::pi / 16, 1.0, std::numbers::pi}) {
    const std::complex<double> exact = influence_sum(theta, 0);
    const std::complex<double> error = symbol(theta) / compliance(material) / exact - 1.0;
    EXPECT_LT(std::abs(error), theta < 0.1 ? 1e-5 : 1e-7) << theta;
  }
}

TEST(Amplification, IsTheQuotientOfShiftedAndUnshiftedSums) {
  for (const double c : {0.05, 0.5, 0.8, 1.0, 1.7}) {
    const Amplification g(PlaneKernel(material, 1), constant_shape(), 1, c);
    for (const double theta : {std::numbers::pi / 16, 1.0, 2.0, std::numbers::pi}) {
      const std::complex<double> exact = influence_sum(theta, c) / influence_sum(theta, 0);
      EXPECT_LT(std::abs(g(theta) - exact), 1e-7) << c << ' ' << theta;
    }
  }
}

// Stable for any step, and a translation for a whole one.
TEST(Amplification, NeverAmplifies) {
  for (const ShapeFunction& shape : {constant_shape(), linear_shape()}) {
    for (const double c : {1e-3, 0.05, 0.2, 0.5, 0.8, 0.99, 1.0, 1.3, 2.0}) {
      const Amplification g(StripKernel(material, 40), shape, 1, c);
      for (int k = 2; k <= 64; ++k) {
        const double theta = k * std::numbers::pi / 64;
        EXPECT_LT(std::abs(g(theta)), 1 + 1e-7) << c << ' ' << theta;
        if (c != std::round(c)) continue;
        EXPECT_LT(std::abs(g(theta) - std::polar(1.0, c * theta)), 1e-6) << c << ' ' << theta;
      }
    }
  }
}

TEST(FourierInverse, TransformsAndRotationsUndoEachOther) {
  for (const Eigen::Index n : {6, 7}) {
    const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(n, -1, 3).array().square();
    EXPECT_NEAR((inverse_transform(fourier_coefficients(v)) - v).norm(), 0, 1e-14);
    EXPECT_EQ(diagonal_in_the_middle(diagonal_first(v)), v);
    EXPECT_EQ(diagonal_first(v)[0], v[middle_index(n)]);
    EXPECT_NEAR(std::abs(fourier_coefficients(v)[0] - v.sum()), 0, 1e-14);
  }
}

TEST(FourierInverse, IsExactForACirculantMatrix) {
  // t_k = t_(k - n): the matrix knows no boundary.
  const Eigen::Index n = 9;
  const Eigen::VectorXd t = Eigen::VectorXd::NullaryExpr(
      n, [](Eigen::Index k) { return k == 0 ? 4.0 : 1.0 / static_cast<double>(k * k); });
  const Eigen::VectorXd row =
      Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return t[(n - k) % n]; });
  const Toeplitz matrix(t, row);
  const Eigen::VectorXd column = approximate_inverse_column(matrix);
  const Eigen::VectorXd unit = matrix.dense() * column;
  EXPECT_NEAR((unit - Eigen::VectorXd::Unit(n, middle_index(n))).norm(), 0, 1e-14);
}

TEST(FourierInverse, TheToeplitzMatrixHasItsMiddleColumn) {
  const Eigen::VectorXd column = Eigen::VectorXd::LinSpaced(8, 1, 8);
  const Toeplitz matrix = toeplitz_from_middle_column(column);
  EXPECT_EQ(middle_column(matrix), column);
  EXPECT_EQ(matrix(0, 7), 0);
}

}  // namespace microslip::spectrum_test
