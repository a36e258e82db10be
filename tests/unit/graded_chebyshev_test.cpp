// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/graded_chebyshev.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip {
namespace {

// Singular at distance 0, which is as near as it may be.
TEST(GradedChebyshev, FollowsASingularFunctionAndItsIntegral) {
  const double nearest = 1e-6;
  int evaluations = 0;
  const GradedChebyshev inverse(
      [&](double d) {
        ++evaluations;
        return 1 / d;
      },
      nearest, 3);
  EXPECT_EQ(evaluations, 16 * 22);  // 2^21 < 3e6 < 2^22
  for (double d = nearest; d <= 3; d *= 1.037) {
    EXPECT_NEAR(inverse(d) * d, 1, 2e-12) << d;
    EXPECT_NEAR(inverse.integral(d), std::log(d / nearest), 2e-12) << d;
  }
  EXPECT_NEAR(inverse(3) * 3, 1, 2e-12);
}

TEST(GradedChebyshev, NeedsOneIntervalForOneDistance) {
  const GradedChebyshev square([](double d) { return d * d; }, 2, 2);
  EXPECT_NEAR(square(2), 4, 1e-14);
  EXPECT_NEAR(square.integral(2), 0, 1e-14);
}

}  // namespace
}  // namespace microslip
