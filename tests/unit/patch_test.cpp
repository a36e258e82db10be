// SPDX-License-Identifier: GPL-3.0-or-later
// Joined rows on an ellipse: displacements against integrals in polar coordinates about the point,
// and Kalker's coefficients.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "microslip/patch/patch_response.hpp"

namespace microslip::patch_test {

using Eigen::Index;
using std::numbers::pi;

/// The three integrals of p = sqrt((1 - s)/(1 + s)), s = x/a(y), over the ellipse: with x' = x - R
/// cos, y' = y - R sin, the area R dR cancels what is singular.
Eigen::Vector3d in_polar_coordinates(double a, double b, double x, double y) {
  const auto along = [&](double angle) {
    const double c = std::cos(angle) / a, s = std::sin(angle) / b;
    const double u = x / a, v = y / b;
    const double p = c * c + s * s, q = u * c + v * s, r = std::max(0.0, 1 - u * u - v * v);
    const double end = (q + std::sqrt(q * q + p * r)) / p;
    static boost::math::quadrature::tanh_sinh<double> rule;
    return rule.integrate(
        [&](double distance) -> double {
          const double across = (y - distance * std::sin(angle)) / b;
          const double half = a * std::sqrt(std::max(0.0, 1 - across * across));
          const double place = x - distance * std::cos(angle);
          return half > 0 && half + place > 0
                     ? std::sqrt(std::max(0.0, half - place) / (half + place))
                     : 0;
        },
        0.0, end, 1e-9);
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  constexpr int parts = 60;
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  for (int i = 0; i < parts; ++i) {
    const double from = 2 * pi * i / parts, to = 2 * pi * (i + 1) / parts;
    for (int k = 0; k < 3; ++k) {
      sum[k] += Gauss::integrate(
          [&](double angle) {
            const double factor = k == 0   ? 1
                                  : k == 1 ? std::pow(std::sin(angle), 2)
                                           : std::sin(angle) * std::cos(angle);
            return factor * along(angle);
          },
          from, to);
    }
  }
  return sum;
}

TEST(JoinedRows, DisplacementsAreThoseOfTheTractions) {
  std::mt19937 random(3);
  for (const double ratio : {0.3, 1.0, 4.0}) {
    const JoinedRows rows(ratio, 7, 6);
    const JoinedRows::Kernels kernels = rows.kernels();
    for (int sample = 0; sample < 4; ++sample) {
      const Index k = std::uniform_int_distribution<Index>(0, 6)(random);
      const Index j = std::uniform_int_distribution<Index>(0, 11)(random);
      const Eigen::Vector3d exact = in_polar_coordinates(
          rows.shape().half_width(), rows.shape().lateral_half_width(), rows.x(j, k), rows.y(k));
      const Index point = rows.point(j, k);
      EXPECT_NEAR(kernels.near.row(point).sum(), exact[0], 3e-4 * exact[0]) << ratio;
      EXPECT_NEAR(kernels.across.row(point).sum(), exact[1], 3e-4 * exact[0]) << ratio;
      EXPECT_NEAR(kernels.mixed.row(point).sum(), exact[2], 3e-4 * exact[0]) << ratio;
    }
  }
}

TEST(JoinedRows, MomentsAreThoseOfTheTractions) {
  const JoinedRows rows(2, 6, 5);
  const Eigen::Vector3d whole = rows.moments().rowwise().sum();
  const double a = rows.shape().half_width();
  // Along a row p is integrated to pi a(y), p x to - pi a(y)^2/2.
  EXPECT_NEAR(whole[0], pi * pi / 2, 1e-12);
  EXPECT_NEAR(whole[1], -pi / 2 * a * 4.0 / 3, 1e-12);
  EXPECT_NEAR(whole[2], 0, 1e-12);
}

// Values are by Galin's theorem.
TEST(PatchResponse, HasKalkersCoefficientsOnFewCells) {
  const auto errors = [](Index size) {
    const Eigen::Matrix3d linear = PatchResponse(JoinedRows(1, size, size), 0.25).linear();
    return Eigen::Vector4d(-linear(0, 0) / 4.112819 - 1, -linear(1, 1) / 3.668295 - 1,
                           -linear(1, 2) / 1.466109 - 1, -linear(2, 2) / 1.184303 - 1);
  };
  EXPECT_LT(errors(5).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_LT(errors(10).cwiseAbs().maxCoeff(), 1.5e-4);
  EXPECT_LT(errors(20).cwiseAbs().maxCoeff(), 3e-5);
}

TEST(PatchResponse, IsMirroredInTheRolling) {
  for (const double ratio : {0.2, 1.0, 3.0}) {
    for (const Index rows : {1, 2, 4, 7}) {
      const Eigen::Matrix3d linear = PatchResponse(JoinedRows(ratio, rows, 4), 0.3).linear();
      for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 0}, {2, 0}}) {
        EXPECT_NEAR(linear(i, j), 0, 1e-12 * linear.norm()) << ratio << ' ' << rows;
      }
    }
  }
}

TEST(PatchResponse, IsIsotropicWithoutPoissonsRatio) {
  const Eigen::Matrix3d linear = PatchResponse(JoinedRows(2, 6, 8), 0).linear();
  EXPECT_NEAR(linear(0, 0), linear(1, 1), 1e-12 * std::abs(linear(0, 0)));
}

TEST(PatchResponse, IsReciprocal) {
  for (const double ratio : {0.2, 1.0, 5.0}) {
    const Eigen::Matrix3d linear = PatchResponse(JoinedRows(ratio, 14, 14), 0.4).linear();
    EXPECT_NEAR(linear(2, 1) / -linear(1, 2), 1, 1e-3) << ratio;
  }
}

// Rows of an ellipse that is narrow along the rolling are those of the line contact: C11 and C22
// are pi^2/4 over 1 - nu and over 1.
TEST(PatchResponse, TendsToTheLineContact) {
  const Eigen::Matrix3d linear = PatchResponse(JoinedRows(1e-3, 40, 6), 0.3).linear();
  EXPECT_NEAR(-linear(0, 0), pi * pi / 4 / 0.7, 5e-3);
  EXPECT_NEAR(-linear(1, 1), pi * pi / 4, 5e-3);
}

TEST(PatchResponse, RefusesBadNumbers) {
  const auto message = [](const auto& make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  using testing::StartsWith;
  EXPECT_THAT(message([] { JoinedRows(0, 5, 5); }), StartsWith("ratio = 0: expected"));
  EXPECT_THAT(message([] { JoinedRows(1, 0, 5); }), StartsWith("rows = 0: expected"));
  EXPECT_THAT(message([] { JoinedRows(1, 5, 0); }), StartsWith("elements = 0: expected"));
  EXPECT_THAT(message([] { PatchResponse(JoinedRows(1, 5, 5), 0.6); }),
              StartsWith("poisson_ratio = 0.6: expected"));
}

}  // namespace microslip::patch_test
