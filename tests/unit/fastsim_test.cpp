// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/fastsim.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/reference/carter.hpp"
#include "microslip/support/require.hpp"

namespace microslip::fastsim_test {

/// Kalker's own algorithm: from slice to slice the traction grows by the rigid slip over L, and is
/// cut off where it exceeds the parabola.
double by_slices(double a, double most, double flexibility, double creepage, int slices) {
  const double dx = 2 * a / slices;
  double traction = 0, force = 0;
  for (int i = 0; i < slices; ++i) {
    const double x = a - (i + 0.5) * dx;
    traction -= creepage * (i == 0 ? dx / 2 : dx) / flexibility;
    const double bound = 0.75 * most / a * (1 - x * x / (a * a));
    if (std::abs(traction) > bound) traction = std::copysign(bound, traction);
    force += traction * dx;
  }
  return force;
}

TEST(Fastsim, IsWhatItsAlgorithmGivesInManySlices) {
  const double a = 3, most = 700, slope = 2e5;
  const Fastsim fastsim(a, most, slope);
  for (const double part : {-1.5, -0.6, -0.05, 0.01, 0.2, 0.5, 0.99, 1.0, 2.0}) {
    const double creepage = part * fastsim.full_sliding_creepage();
    const double sliced = by_slices(a, most, fastsim.flexibility(), creepage, 4000);
    EXPECT_NEAR(fastsim.force(creepage), sliced, 1e-6 * most) << part;
    double force = 0;
    for (int i = 0; i < 4000; ++i) {
      force += fastsim.traction(-a + (i + 0.5) * a / 2000, creepage) * a / 2000;
    }
    EXPECT_NEAR(force, fastsim.force(creepage), 1e-6 * most) << part;
  }
  EXPECT_EQ(fastsim.traction(3, 1), 0);
  EXPECT_EQ(fastsim.traction(-3.5, 1), 0);
}

TEST(Fastsim, BeginsWithTheSlopeAndEndsInFullSliding) {
  const Fastsim fastsim(2, 50, 3e4);
  EXPECT_NEAR(fastsim.force(1e-9) / -3e-5, 1, 1e-5);
  EXPECT_NEAR(fastsim.force(fastsim.full_sliding_creepage()), -50, 1e-12);
  EXPECT_EQ(fastsim.force(1e9), -50);
  EXPECT_EQ(fastsim.force(-1e9), 50);
  EXPECT_EQ(fastsim.force(0), 0);
}

// Carter's force is 2u - u^2 of full sliding at the part u of the creepage where all slides, and
// FASTSIM's 2u - 4u^2/3 + 8u^3/27: the difference is largest at u = 3/4.
TEST(Fastsim, IsASixteenthBelowCarterInPlaneStrain) {
  const Material steel{82000, 0.28};
  const HertzBound bound(5, 300);
  const Fastsim fastsim(5, bound.total(), std::numbers::pi * 5 / compliance(steel));
  const double sliding = compliance(steel) * bound.peak();
  double largest = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double creepage = sliding * i / 1000;
    const double carter = Carter::from_creepage(steel, bound, creepage).force();
    const double below = (fastsim.force(creepage) - carter) / bound.total();
    EXPECT_GE(below, -1e-12) << i;
    largest = std::max(largest, below);
  }
  EXPECT_NEAR(largest, 1. / 16, 1e-12);
}

TEST(Fastsim, NamesWhatItRejects) {
  EXPECT_THROW(Fastsim(0, 1, 1), BadParameter);
  EXPECT_THROW(Fastsim(1, -1, 1), BadParameter);
  EXPECT_THROW(Fastsim(1, 1, NAN), BadParameter);
}

}  // namespace microslip::fastsim_test
