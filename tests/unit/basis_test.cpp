// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/basis.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "microslip/halfspace/leading_edge.hpp"

namespace microslip::basis_test {

TEST(ShapeFunction, ValuesOfTheHat) {
  const ShapeFunction hat = linear_shape();
  EXPECT_DOUBLE_EQ(hat.value(0), 1);
  EXPECT_DOUBLE_EQ(hat.value(-0.25), 0.75);
  EXPECT_DOUBLE_EQ(hat.value(0.75), 0.25);
  EXPECT_DOUBLE_EQ(hat.value(1.5), 0);
}

double sum_at(const Basis& basis, const std::function<double(double)>& coefficient, double s) {
  constexpr Eigen::Index n = 11;  // nodes at -5 ... 5, the pattern as in a grid
  double sum = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double node = static_cast<double>(i - 5);
    sum += coefficient(node) * basis.shapes()[basis.shape_of(i, n)].value(s - node);
  }
  return sum;
}

TEST(Basis, FunctionsReproducePolynomialsOfTheirDegree) {
  for (const double s : {0.1, 0.3, 0.7, 1.2, -0.4, -1.6}) {
    for (const Basis& basis : {constant_basis(), linear_basis(), quadratic_basis()}) {
      EXPECT_NEAR(sum_at(
                      basis, [](double) { return 1; }, s),
                  1, 1e-15)
          << basis.name();
    }
    for (const Basis& basis : {linear_basis(), quadratic_basis()}) {
      EXPECT_NEAR(sum_at(
                      basis, [](double x) { return x; }, s),
                  s, 1e-15)
          << basis.name();
    }
    EXPECT_NEAR(sum_at(
                    quadratic_basis(), [](double x) { return x * x; }, s),
                s * s, 1e-15);
  }
}

TEST(Basis, WeightsAreIntegrals) {
  EXPECT_TRUE(constant_basis().weights(0.5, 3).isApprox(Eigen::Vector3d(0.5, 0.5, 0.5)));
  EXPECT_TRUE(quadratic_basis().weights(3, 3).isApprox(Eigen::Vector3d(4, 2, 4)));  // Simpson
  EXPECT_TRUE(trimmed_linear_basis(0.5).weights(1, 3).isApprox(Eigen::Vector3d(1, 1, 0.875)));
  EXPECT_TRUE(edge_constant_basis().weights(1, 2).isApprox(Eigen::Vector2d(1, 1)));
}

TEST(Basis, TheTrimmedHatEndsAtTheEdge) {
  const ShapeFunction last = trimmed_linear_basis(0.4).shapes()[1];
  EXPECT_DOUBLE_EQ(last.value(0.3), 0.7);
  EXPECT_DOUBLE_EQ(last.value(0.41), 0);
  EXPECT_THROW(trimmed_linear_basis(0), std::invalid_argument);
}

TEST(ShapeFunction, IntegralsOfAQuadraticAreExact) {
  const ShapeFunction parabola({{-1, 1, {1, 0, -1}}});  // 1 - s^2
  const auto antiderivative = [](double s) { return s - s * s * s / 3; };
  EXPECT_DOUBLE_EQ(parabola.integral(-0.5, 0.75), antiderivative(0.25) - antiderivative(-0.5));
  EXPECT_DOUBLE_EQ(parabola.integral(-3, 10), 4.0 / 3);
  EXPECT_DOUBLE_EQ(parabola.integral(1, 2), 0);
}

TEST(ShapeFunction, IntegralsAcrossPiecesAreExact) {
  EXPECT_DOUBLE_EQ(linear_shape().integral(-0.5, 1), 0.75);
  EXPECT_DOUBLE_EQ(constant_shape().integral(0.25, 5), 0.25);
}

TEST(ShapeFunction, ShortIntegralsKeepTheirDigits) {
  EXPECT_DOUBLE_EQ(linear_shape().integral(0.25, 1e-12), (0.75 - 0.5e-12) * 1e-12);
}

TEST(Basis, IsKnownByItsFunctions) {
  const Basis hats("hats", Basis::Pattern::uniform, {linear_shape()});
  EXPECT_TRUE(hats.has_only(linear_shape()));
  EXPECT_FALSE(hats.has_only(constant_shape()));
  EXPECT_FALSE(trimmed_linear_basis(0.5).has_only(linear_shape()));
  EXPECT_EQ(leading_edge_constants(hats, 0).offset,
            leading_edge_constants(linear_basis(), 0).offset);
}

TEST(Basis, RejectsAnUnknownName) { EXPECT_THROW(make_basis("cubic"), std::invalid_argument); }

}  // namespace microslip::basis_test
