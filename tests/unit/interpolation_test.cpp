// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/interpolation.hpp"

#include <gtest/gtest.h>

namespace microslip::interpolation_test {

TEST(Interpolation, IsLinearBetweenAndConstantBeyondPositions) {
  const Eigen::Vector3d positions(-1, 0, 3);
  const Eigen::Vector3d values(2, 5, -1);
  EXPECT_EQ(interpolated(positions, values, -1.5), 2);
  EXPECT_EQ(interpolated(positions, values, -0.5), 3.5);
  EXPECT_EQ(interpolated(positions, values, 0.0), 5);
  EXPECT_DOUBLE_EQ(interpolated(positions, values, 1.0), 3);
  EXPECT_EQ(interpolated(positions, values, 3.0), -1);
  EXPECT_EQ(interpolated(positions, values, 4.0), -1);
  const Eigen::VectorXd one = Eigen::VectorXd::Constant(1, 7);
  EXPECT_EQ(interpolated(one, one, Eigen::VectorXd::LinSpaced(2, 6, 8)),
            Eigen::VectorXd::Constant(2, 7));
}

}  // namespace microslip::interpolation_test
