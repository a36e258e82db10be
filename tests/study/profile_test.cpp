// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/profile.hpp"

#include <gtest/gtest.h>

namespace microslip::experiments::profile_test {

TEST(TurningPoints, CountsInteriorExtrema) {
  EXPECT_EQ(turning_points(Eigen::Vector4d(1, 2, 3, 4)), 0);
  EXPECT_EQ(turning_points(Eigen::Vector4d(1, 2, 1, 2)), 2);
  EXPECT_EQ(turning_points(Eigen::Vector4d(1, 2, 2, 3)), 0);
  EXPECT_EQ(turning_points(Eigen::Vector4d(1, 2, 2, 1)), 1);
  EXPECT_EQ(turning_points(Eigen::Vector4d(1, 2, 1.9, 3), 0.2), 0);
}

TEST(TotalVariation, SumsRisesAndFalls) {
  EXPECT_DOUBLE_EQ(total_variation(Eigen::Vector4d(1, 3, 2, 2.5)), 3.5);
}

TEST(Peak, OfASmoothAndOfASharpOne) {
  const Peak sharp = peak_of(Eigen::VectorXd::Unit(9, 3));
  EXPECT_DOUBLE_EQ(sharp.height, 1);
  EXPECT_DOUBLE_EQ(sharp.position, 3);
  EXPECT_DOUBLE_EQ(sharp.width, 1);
  Eigen::VectorXd parabola(9);
  for (int i = 0; i < 9; ++i) parabola[i] = 20 - (i - 4.2) * (i - 4.2);
  EXPECT_NEAR(peak_of(parabola).position, 4.2, 1e-12);
  EXPECT_DOUBLE_EQ(peak_of(Eigen::Vector3d(3, 2, 1)).position, 0);
}

}  // namespace microslip::experiments::profile_test
