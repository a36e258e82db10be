// SPDX-License-Identifier: GPL-3.0-or-later
// Equal rectangles: their influence, products by FFT, and the pressure in them.
#include "microslip/patch/rectangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/patch/rectangle_pressure.hpp"

namespace microslip::rectangles_test {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

/// Values without a pattern.
VectorXd some_values(Index size) {
  return VectorXd::NullaryExpr(size,
                               [](Index i) { return std::sin(12.9898 * static_cast<double>(i)); });
}

TEST(Rectangles, HaveTheirCentresInTheEllipse) {
  const Rectangles circle = Rectangles::in_ellipse(1, 1, 20, 20);
  EXPECT_EQ(circle.size(), 316);
  for (Index e = 0; e < circle.size(); ++e) {
    EXPECT_LT(std::hypot(circle.x(e), circle.y(e)), 1);
    EXPECT_EQ(circle.x(circle.size() - 1 - e), -circle.x(e));
    EXPECT_EQ(circle.y(circle.size() - 1 - e), -circle.y(e));
  }
  const Rectangles ellipse = Rectangles::in_ellipse(3, 2, 7, 5);
  EXPECT_NEAR(ellipse.dx(), 6.0 / 7, 1e-15);
  EXPECT_NEAR(ellipse.dy(), 4.0 / 5, 1e-15);
  EXPECT_NEAR(ellipse.x(ellipse.first_of(2)), -3 + 3.0 / 7, 1e-15);
  EXPECT_EQ(ellipse.y(ellipse.first_of(2)), 0);
  EXPECT_THROW(Rectangles::in_ellipse(1, 0, 5, 5), std::invalid_argument);
  EXPECT_THROW(Rectangles::in_ellipse(1, 1, 0, 5), std::invalid_argument);
  EXPECT_THROW(Rectangles(1, 1, Rectangles::Mask::Constant(2, 2, false)), std::invalid_argument);
}

// Sums over midpoints share nothing with the closed forms.
TEST(Rectangles, HaveTheIntegralsOfTheirKernels) {
  const Rectangles grid(0.7, 0.4, Rectangles::Mask::Constant(4, 3, true));
  constexpr double ahead = 0.3;
  const RectangleKernels kernels(grid, ahead);
  for (Index k = -2; k <= 2; ++k) {
    for (Index i = -3; i <= 3; ++i) {
      if (i == 0 && k == 0) continue;  // the point lies in the rectangle
      double near = 0, across = 0, mixed = 0;
      constexpr int parts = 400;
      for (int p = 0; p < parts; ++p) {
        for (int q = 0; q < parts; ++q) {
          const double x = 0.7 * (static_cast<double>(i) + ahead - (p + 0.5) / parts + 0.5);
          const double y = 0.4 * (static_cast<double>(k) - (q + 0.5) / parts + 0.5);
          const double r = std::hypot(x, y);
          near += 1 / r;
          across += y * y / (r * r * r);
          mixed += x * y / (r * r * r);
        }
      }
      const double area = 0.28 / parts / parts;
      EXPECT_NEAR(kernels.near(i + 3, k + 2), area * near, 3e-6) << i << ' ' << k;
      EXPECT_NEAR(kernels.across(i + 3, k + 2), area * across, 3e-6) << i << ' ' << k;
      EXPECT_NEAR(kernels.mixed(i + 3, k + 2), area * mixed, 3e-6) << i << ' ' << k;
    }
  }
  // The middle of a square with the side h: 4 h arsinh(1).
  const Rectangles square(2, 2, Rectangles::Mask::Constant(1, 1, true));
  EXPECT_NEAR(RectangleKernels(square, 0).near(0, 0), 8 * std::asinh(1.0), 1e-14);
  EXPECT_NEAR(RectangleKernels(square, 0).across(0, 0), 4 * std::asinh(1.0), 1e-14);
  EXPECT_TRUE(RectangleKernels(square, 0.5).near.allFinite());  // the point lies on a side
}

TEST(Rectangles, HaveProductsByFftThatAreDirectSums) {
  const Rectangles grid = Rectangles::in_ellipse(1.3, 0.6, 13, 8);
  const double nu = 0.3;
  const Index n = grid.size();
  const RectangleInfluence influence(grid, nu, {{2, 0}, {-3, 0.4}});
  const VectorXd tractions = some_values(2 * n);
  VectorXd product, expected = VectorXd::Zero(2 * n);
  influence.apply(tractions, product);
  const RectangleKernels here(grid, 0), ahead(grid, 0.4);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index c = grid.column(i) - grid.column(j) + grid.columns() - 1;
      const Index r = grid.row(i) - grid.row(j) + grid.rows() - 1;
      const double near = 2 * here.near(c, r) - 3 * ahead.near(c, r);
      const double across = 2 * here.across(c, r) - 3 * ahead.across(c, r);
      const double mixed = 2 * here.mixed(c, r) - 3 * ahead.mixed(c, r);
      const double x = tractions[j], y = tractions[n + j];
      expected[i] += ((near - nu * across) * x + nu * mixed * y) / pi;
      expected[n + i] += (nu * mixed * x + ((1 - nu) * near + nu * across) * y) / pi;
    }
  }
  EXPECT_LT((product - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
}

// Equal tractions in all rectangles are those of one large rectangle.
TEST(Rectangles, AreOneRectangleUnderEqualTractions) {
  constexpr Index size = 9;
  const Rectangles grid(0.2, 0.3, Rectangles::Mask::Constant(size, size, true));
  const Rectangles one(0.2 * size, 0.3 * size, Rectangles::Mask::Constant(1, 1, true));
  const double nu = 0.25;
  VectorXd tractions(2 * grid.size()), displacement;
  tractions << VectorXd::Constant(grid.size(), 1), VectorXd::Constant(grid.size(), 2);
  RectangleInfluence(grid, nu, {{1, 0}}).apply(tractions, displacement);
  for (Index i = 0; i < size; ++i) {  // in the middle row
    const RectangleKernels kernels(one, static_cast<double>(i - size / 2) / size);
    const double near = kernels.near(0, 0), across = kernels.across(0, 0);
    const Index e = grid.first_of(size / 2) + i;
    EXPECT_NEAR(displacement[e], (near - nu * across) / pi, 1e-14);
    EXPECT_NEAR(displacement[grid.size() + e], 2 * ((1 - nu) * near + nu * across) / pi, 1e-14);
  }
}

// CONTACT v25.2, T = 3, B = 0 with a = 1 mm, G = 1, nu = 0.28 and Fn = 1 N: number of elements in
// contact, largest pressure and approach. CONTACT's tolerance is 1e-8; ours leaves 1e-11.
TEST(RectanglePressure, IsContacts) {
  const struct {
    double ratio;
    Index size, touching;
    double largest, approach;
  } cases[] = {
      {1, 20, 316, 0.4764803369, 0.539771659},   {1, 28, 624, 0.4769536881, 0.5398755933},
      {1, 40, 1272, 0.4772009093, 0.5399241713}, {2, 20, 320, 0.9529307945, 0.7410234166},
      {2, 28, 620, 0.953893288, 0.7411785709},   {2, 40, 1276, 0.9543992732, 0.7412509406}};
  for (const auto& [ratio, size, touching, largest, approach] : cases) {
    const RectanglePressure found = pressure_of_rectangles(1, 1 / ratio, size, size);
    EXPECT_EQ(found.contact.size(), touching);
    // Hertz: p0 = 3/2 Fn/(pi a b), and the approach is (1 - nu) p0 b K(k).
    const double p0 = 1.5 * ratio / pi;
    EXPECT_NEAR(p0 * found.pressure.maxCoeff(), largest, 6e-10) << ratio << ' ' << size;
    const double by_hertz =
        0.72 * p0 / ratio * std::comp_ellint_1(std::sqrt(1 - 1 / (ratio * ratio)));
    EXPECT_NEAR(by_hertz * found.approach, approach, 1e-9) << ratio << ' ' << size;
    EXPECT_NEAR(found.pressure.sum() * found.contact.area(), 2 * pi / 3 / ratio, 1e-12);
  }
}

}  // namespace microslip::rectangles_test
