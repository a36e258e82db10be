// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/traction_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "microslip/halfspace/grid.hpp"

namespace microslip::traction_bound_test {

TEST(HertzBound, IsAnEllipseThatEndsAtTheEdges) {
  const HertzBound bound(2, 3);
  EXPECT_DOUBLE_EQ(bound(0), 3);
  EXPECT_DOUBLE_EQ(bound(1.2), 3 * 0.8);
  EXPECT_DOUBLE_EQ(bound(-2), 0);
  EXPECT_DOUBLE_EQ(bound(2.1), 0);
  EXPECT_THROW(HertzBound(2, 0), std::invalid_argument);
}

TEST(HertzBound, TotalIsItsIntegral) {
  const HertzBound bound(2, 3);
  const Grid fine({.half_width = 2, .elements = 10000});
  EXPECT_NEAR(bound_at(bound, fine.nodes()).sum() * fine.spacing(), bound.total(), 1e-5);
}

TEST(TabulatedBound, IsLinearBetweenItsPointsAndTowardsTheEdges) {
  const TabulatedBound bound(2, Eigen::Vector3d(-1, 0, 1.5), Eigen::Vector3d(2, 3, 1));
  EXPECT_DOUBLE_EQ(bound(-1), 2);
  EXPECT_DOUBLE_EQ(bound(0), 3);
  EXPECT_DOUBLE_EQ(bound(1.5), 1);
  EXPECT_DOUBLE_EQ(bound(-0.25), 2.75);
  EXPECT_DOUBLE_EQ(bound(-1.5), 1);
  EXPECT_DOUBLE_EQ(bound(1.75), 0.5);
  EXPECT_DOUBLE_EQ(bound(2), 0);
  EXPECT_DOUBLE_EQ(bound(2.1), 0);
  EXPECT_DOUBLE_EQ(bound.total(), 1 + 2.5 + 3 + 0.25);
}

TEST(TractionBound, MeansAddUpToTheTotal) {
  const Eigen::Vector3d x(-1, 0, 1.5), values(2, 3, 1);
  for (const TractionBound& bound :
       {TractionBound(HertzBound(2, 3)), TractionBound(TabulatedBound(2, x, values))}) {
    const Eigen::VectorXd centres = Eigen::VectorXd::LinSpaced(31, -2.11, 2.09);
    const Eigen::VectorXd means = mean_bound_around(bound, centres, 0.14);
    EXPECT_NEAR(means.sum() * 0.14, full_sliding_force(bound), 1e-13);
    EXPECT_NEAR(means[15], bound_at(bound, centres.segment(15, 1))[0], 0.05);
    EXPECT_GE(means.minCoeff(), 0);
  }
}

// 0.3 inches are 7.62 mm to a rounding, on either side.
TEST(TabulatedBound, TakesRowsNextToTheEdgesAsAtThem) {
  for (const double half_width : {std::nextafter(7.62, 0), 7.62, std::nextafter(7.62, 8)}) {
    const TabulatedBound bound(half_width, Eigen::Vector2d(-7.62, 7.62), Eigen::Vector2d(2, 4));
    EXPECT_EQ(bound(half_width), 4);
    EXPECT_EQ(bound(-half_width), 2);
    EXPECT_NEAR(bound.total(), 6 * 7.62, 1e-13);
  }
  // A printed edge has seven digits.
  const TabulatedBound printed(7.62, Eigen::Vector2d(0, 7.62 * (1 + 9e-7)), Eigen::Vector2d(2, 4));
  EXPECT_EQ(printed(7.62), 4);
  EXPECT_THROW(TabulatedBound(7.62, Eigen::Vector2d(0, 7.62 * (1 + 2e-6)), Eigen::Vector2d(2, 4)),
               std::invalid_argument);
}

TEST(TabulatedBound, KeepsWhatIsGivenAtTheEdges) {
  const TabulatedBound bound(1, Eigen::Vector2d(-1, 1), Eigen::Vector2d(2, 4));
  EXPECT_DOUBLE_EQ(bound(-1), 2);
  EXPECT_DOUBLE_EQ(bound(0), 3);
  EXPECT_DOUBLE_EQ(bound(1), 4);
  EXPECT_DOUBLE_EQ(bound.total(), 6);
}

}  // namespace microslip::traction_bound_test
