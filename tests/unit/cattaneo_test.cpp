// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/cattaneo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/support/quadrature.hpp"

namespace microslip::cattaneo_test {

TEST(Cattaneo, CarriesItsForceWithinTheBound) {
  const HertzBound bound(3, 7);
  const Cattaneo cattaneo({5, 0.3}, bound, -0.64 * bound.total());
  EXPECT_NEAR(cattaneo.stick_ratio(), 0.6, 1e-15);
  const auto traction = [&](double x) { return cattaneo.traction(x); };
  EXPECT_NEAR(integrate(traction, -3, -1.8, 1e-12) + integrate(traction, -1.8, 1.8, 1e-12) +
                  integrate(traction, 1.8, 3, 1e-12),
              -0.64 * bound.total(), 1e-9);
  EXPECT_DOUBLE_EQ(cattaneo.traction(0), -7 * 0.4);
  EXPECT_DOUBLE_EQ(cattaneo.traction(2.4), -bound(2.4));
  EXPECT_DOUBLE_EQ(cattaneo.traction(3.1), 0);
}

// K mu p0 a = 1; 1.985320043 in 50 digits, and the integral of the kernel over the traction.
TEST(Cattaneo, DisplacementIsThatOfItsTraction) {
  const Material material{1.44, 0.28};
  const Cattaneo cattaneo(material, HertzBound(1, 1), 0.64 * std::numbers::pi / 2);
  EXPECT_NEAR(cattaneo.displacement(200), 1.985320043, 1e-9);
  const auto density = [&](double x) {
    return -std::log(x / 200) / std::numbers::pi * (cattaneo.traction(x) + cattaneo.traction(-x));
  };
  EXPECT_NEAR(integrate(density, 0, 0.6, 1e-11) + integrate(density, 0.6, 1, 1e-11),
              cattaneo.displacement(200), 1e-9);
}

TEST(Cattaneo, Limits) {
  const HertzBound bound(1, 1);
  EXPECT_EQ(Cattaneo({1, 0.28}, bound, 0).traction(0.3), 0);
  EXPECT_EQ(Cattaneo({1, 0.28}, bound, 0).displacement(200), 0);
  EXPECT_DOUBLE_EQ(Cattaneo({1, 0.28}, bound, bound.total()).traction(0.6), 0.8);
  EXPECT_THROW(Cattaneo({1, 0.28}, bound, 1.01 * bound.total()), std::invalid_argument);
}

}  // namespace microslip::cattaneo_test
