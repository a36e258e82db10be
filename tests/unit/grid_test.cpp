// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "microslip/linalg/toeplitz.hpp"

namespace microslip::grid_test {

TEST(Grid, HalfOffsetsGiveElementCentres) {
  const Grid grid({.half_width = 2, .elements = 4});
  EXPECT_DOUBLE_EQ(grid.spacing(), 1);
  const Eigen::VectorXd x = grid.nodes();
  EXPECT_TRUE(x.isApprox(Eigen::Vector4d(-1.5, -0.5, 0.5, 1.5)));
}

TEST(Grid, OffsetsAreTheDistancesToTheEdges) {
  const Grid grid({.half_width = 1, .elements = 7, .leading_offset = 0.2, .trailing_offset = 0.9});
  const Eigen::VectorXd x = grid.nodes();
  EXPECT_NEAR(1 - x[6], 0.2 * grid.spacing(), 1e-15);
  EXPECT_NEAR(x[0] + 1, 0.9 * grid.spacing(), 1e-15);
  EXPECT_NEAR(x[3] - x[2], grid.spacing(), 1e-15);
}

TEST(Grid, RejectsWhatIsOutsideItsRange) {
  EXPECT_THROW(Grid({.half_width = 0, .elements = 4}), std::invalid_argument);
  EXPECT_THROW(Grid({.half_width = 1, .elements = 0}), std::invalid_argument);
  EXPECT_THROW(Grid({.half_width = 1, .elements = Grid::max_elements + 1}), std::invalid_argument);
  EXPECT_THROW(Grid({.half_width = 1, .elements = 4, .leading_offset = 1.1}),
               std::invalid_argument);
  EXPECT_THROW(Grid({.half_width = 1, .elements = 4, .trailing_offset = -0.1}),
               std::invalid_argument);
  EXPECT_THROW(Grid({.half_width = 1, .elements = 1, .leading_offset = 0, .trailing_offset = 0}),
               std::invalid_argument);
}

TEST(Toeplitz, TakesColumnsBelowAndRowsAboveTheDiagonal) {
  const Toeplitz t(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, -2, -3));
  Eigen::Matrix3d expected;
  expected << 1, -2, -3, 2, 1, -2, 3, 2, 1;
  EXPECT_EQ(t.dense(), expected);
}

TEST(Toeplitz, RejectsColumnsAndRowsThatDisagree) {
  EXPECT_THROW(Toeplitz(Eigen::Vector2d(1, 2), Eigen::Vector2d(3, 2)), std::invalid_argument);
  EXPECT_THROW(Toeplitz(Eigen::Vector2d(1, 2), Eigen::Vector3d(1, 2, 2)), std::invalid_argument);
}

}  // namespace microslip::grid_test
