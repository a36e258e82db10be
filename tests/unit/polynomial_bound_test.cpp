// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "microslip/friction/traction_bound.hpp"

namespace microslip::polynomial_bound_test {

Eigen::VectorXd coefficients(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.begin(),
                                           static_cast<Eigen::Index>(values.size()));
}

TEST(PolynomialBound, IsThePolynomialTimesHertz) {
  const PolynomialBound bound(2, 5, coefficients({1, 0.3, 0.2}));
  const HertzBound hertz(2, 5);
  for (const double x : {-1.9, -0.7, 0.0, 1.3}) {
    const double t = x / 2;
    EXPECT_NEAR(bound(x), hertz(x) * (1 + 0.3 * t + 0.2 * t * t), 1e-14);
  }
  EXPECT_EQ(bound(2.1), 0);
  const PolynomialBound plain(2, 5, coefficients({1}));
  EXPECT_NEAR(plain.integral(0.4), hertz.integral(0.4), 1e-14);
  EXPECT_NEAR(plain.total(), hertz.total(), 1e-14);
}

TEST(PolynomialBound, RefusesWhatIsNoBound) {
  EXPECT_THROW(PolynomialBound(1, 1, coefficients({1, -1.1})), std::invalid_argument);
  EXPECT_THROW(PolynomialBound(1, 1, coefficients({0, 0})), std::invalid_argument);
  EXPECT_THROW(PolynomialBound(1, 1, Eigen::VectorXd()), std::invalid_argument);
  EXPECT_THROW(PolynomialBound(1, 1, Eigen::VectorXd::Ones(34)), std::invalid_argument);
  EXPECT_NO_THROW(PolynomialBound(1, 1, coefficients({1, -1})));
}

// Around the middle, which is far from both edges, and next to them.
TEST(PolynomialBound, MeansOverLongWidthsAreThoseOfTheIntegral) {
  const PolynomialBound steep(2, 5, Eigen::VectorXd::Ones(33));
  for (const double x : {-1.9, 0.1, 1.2}) {
    for (const double width : {0.2, 1.0, 4.0}) {
      const double begin = std::max(-2.0, x - width / 2), end = std::min(2.0, x + width / 2);
      const double mean = (steep.integral(end) - steep.integral(begin)) / width;
      EXPECT_NEAR(steep.mean_around(x, width) / mean, 1, 1e-11) << x << " " << width;
    }
  }
}

// (t - 0.3)^2 touches zero, up to rounding; a little less is below it within a fiftieth of the
// contact, or at one place.
TEST(PolynomialBound, RefusesAShortDipBelowZeroButNotADoubleZero) {
  EXPECT_NO_THROW(PolynomialBound(1, 1, coefficients({0.09, -0.6, 1})));
  EXPECT_THROW(PolynomialBound(1, 1, coefficients({0.09 - 4e-4, -0.6, 1})), std::invalid_argument);
  EXPECT_THROW(PolynomialBound(1, 1, coefficients({-1e-9, 0, 1})), std::invalid_argument);
}

}  // namespace microslip::polynomial_bound_test
