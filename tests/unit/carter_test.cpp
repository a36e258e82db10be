// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/carter.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace microslip::carter_test {

constexpr Material material{2, 0.28};

TEST(Carter, TakesTheThesisValuesAtStickRatio0p6) {
  const HertzBound bound(1, 1);
  const Carter carter = Carter::from_creepage({1, 0.28}, bound, 0.576);
  EXPECT_NEAR(carter.stick_ratio(), 0.6, 1e-15);
  EXPECT_NEAR(carter.force(), -std::numbers::pi / 2 * 0.64, 1e-15);
  EXPECT_NEAR(carter.traction(-0.5), -std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(carter.traction(0.4), -std::sqrt(0.84) + 0.6, 1e-15);  // centre of the stick zone
  EXPECT_EQ(carter.traction(1.5), 0);
}

TEST(Carter, ForceAndCreepageDescribeTheSameSolution) {
  const HertzBound bound(3, 7);
  for (const double w : {0.5, -0.5, 2.0}) {
    const Carter a = Carter::from_creepage(material, bound, w);
    const Carter b = Carter::from_force(material, bound, a.force());
    EXPECT_NEAR(a.creepage(), w, 1e-14);
    EXPECT_NEAR(b.creepage(), w, 1e-13);
    EXPECT_NEAR(a.traction(1), b.traction(1), 1e-13);
  }
}

TEST(Carter, StickRatioDescribesTheSameSolution) {
  const HertzBound bound(3, 7);
  for (const double stick_ratio : {0.0, 0.3, 1.0}) {
    const Carter carter = Carter::from_stick_ratio(material, bound, stick_ratio);
    EXPECT_NEAR(carter.stick_ratio(), stick_ratio, 1e-15);
    EXPECT_GE(carter.creepage(), 0);
  }
  EXPECT_THROW(Carter::from_stick_ratio(material, bound, 1.1), std::invalid_argument);
}

TEST(Carter, ForceIsTheIntegralOfTheTraction) {
  const HertzBound bound(3, 7);
  const Carter carter = Carter::from_creepage(material, bound, -1);
  boost::math::quadrature::tanh_sinh<double> integrator;
  const double edge = 3 * (1 - 2 * carter.stick_ratio());
  const auto p = [&](double x) { return carter.traction(x); };
  EXPECT_NEAR(integrator.integrate(p, -3.0, edge) + integrator.integrate(p, edge, 3.0),
              carter.force(), 1e-7);
}

TEST(Carter, DissipationIsCreepageTimesForce) {
  const HertzBound bound(3, 7);
  const Carter carter = Carter::from_creepage(material, bound, 2);
  boost::math::quadrature::tanh_sinh<double> integrator;
  const double edge = 3 * (1 - 2 * carter.stick_ratio());
  const auto power = [&](double x) { return -carter.traction(x) * carter.slip(x); };
  EXPECT_NEAR(integrator.integrate(power, -3.0, edge), std::abs(2 * carter.force()), 1e-6);
  EXPECT_EQ(carter.slip(edge + 0.1), 0);
}

TEST(Carter, FullSlidingBeyondTheLastCreepage) {
  const HertzBound bound(3, 7);
  const Carter carter = Carter::from_creepage(material, bound, 100);
  EXPECT_EQ(carter.stick_ratio(), 0);
  EXPECT_NEAR(carter.force(), -bound.total(), 1e-14);
  EXPECT_NEAR(carter.traction(1), -bound(1), 1e-14);
}

TEST(Carter, RejectsAForceAboveFullSliding) {
  const HertzBound bound(3, 7);
  EXPECT_THROW(Carter::from_force(material, bound, 1.01 * bound.total()), std::invalid_argument);
}

}  // namespace microslip::carter_test
