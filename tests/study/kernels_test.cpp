// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "study_tables.hpp"

namespace microslip::experiments::kernels_test {

const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("kernels", read_kernels, kernels,
                {"material.shear_modulus=3", "material.poisson_ratio=0.3", "contact.half_width=2",
                 "contact.peak_traction=0.1", "kernel.length=40", "layers.softness=0.01 1",
                 "grid.elements=200", "curve.points=16", "noise.step=1e-3", "noise.points=4",
                 "edge.points=4", "error.sizes=50 100 200"});
  return all;
}

// The creepage is in units of the slope: at the first order all forces are equal to it.
TEST(KernelsStudy, CurvesRiseFromOneSlopeToFullSliding) {
  const Table& curves = table_named(tables(), "curves");
  for (std::size_t i = 0; i < curves.rows(); ++i) {
    const double creepage = curves.number(i, "creepage");
    const double force = curves.number(i, "force_ratio");
    EXPECT_LT(force, std::min(1 + 1e-9, creepage));
    EXPECT_GT(force, creepage - creepage * creepage / 2);
    const double exact = curves.number(i, "exact");
    if (std::isfinite(exact)) {
      EXPECT_NEAR(force, exact, 2e-4);
    }
  }
}

// Without slip a half-space has 2 (1 - nu)/G w a pi/... and a brush 2 a^2 w/C.
TEST(KernelsStudy, SlopesFallWithTheLayer) {
  const Table& slopes = table_named(tables(), "slopes");
  ASSERT_EQ(slopes.rows(), 4U);
  EXPECT_EQ(slopes.number(0, "slope"), 1);
  EXPECT_LT(slopes.number(1, "slope"), 1);
  EXPECT_LT(slopes.number(2, "slope"), slopes.number(1, "slope"));
  // pi a^2/(2 (1 - nu)/G a) and 2 a^2/C.
  EXPECT_NEAR(slopes.number(3, "slope"), 2 / std::numbers::pi, 1e-3);
}

TEST(KernelsStudy, LayersTakeTheWiggles) {
  const Table& noise = table_named(tables(), "noise");
  EXPECT_GT(noise.latest({{"kernel", "half-space"}, {"step_ratio", 1e-3}}, "wiggle"), 0.05);
  EXPECT_LT(noise.latest({{"softness", 0.01}, {"step_ratio", 1e-3}}, "wiggle"), 0.02);
  EXPECT_LT(noise.latest({{"softness", 1.0}, {"step_ratio", 1e-3}}, "wiggle"), 1e-6);
  EXPECT_LT(noise.latest({{"kernel", "brush"}, {"step_ratio", 1e-3}}, "wiggle"), 1e-6);
}

TEST(KernelsStudy, HasItsOrders) {
  const Table& orders = table_named(tables(), "orders");
  for (std::size_t i = 0; i < orders.rows(); ++i) {
    const bool calibrated = std::get<std::string>(orders.at(i, "scheme")) == "calibrated";
    EXPECT_NEAR(orders.number(i, "order"), calibrated ? 2 : 1, calibrated ? 0.5 : 0.15);
  }
}

TEST(KernelsStudy, ShiftsFadeAsTheyRoll) {
  const Table& transients = table_named(tables(), "transients");
  for (std::size_t i = 0; i < transients.rows(); ++i) {
    const double distance = transients.number(i, "distance");
    const double creepage = transients.number(i, "creepage");
    EXPECT_GT(creepage, 0);
    if (distance > 1) {
      EXPECT_NEAR(creepage, 1, 0.05);
    }
    if (distance < 0.2) {
      EXPECT_LT(creepage, 0.7);
    }
  }
}

TEST(KernelsStudy, ClaimsHold) {
  EXPECT_EQ(verdicts(tables()), std::vector<std::string>(7, "ours"));
}

}  // namespace microslip::experiments::kernels_test
