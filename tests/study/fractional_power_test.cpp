// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fractional_power.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "study_tables.hpp"

namespace microslip::experiments::fractional_power_test {

constexpr Material material{1, 0.28};

const std::vector<Table>& tables() {
  static const std::vector<Table> all = tables_of(
      "fractional_power", read_fractional_power, fractional_power,
      {"reference.refinement=5", "cost.sizes=51 75 101 201 401", "cost.largest_schur=101"});
  return all;
}

// The wiggles of a single one are largest at the trailing edge, ahead of it; the pyramid has hardly
// any; the total stays.
TEST(FractionalPowerStudy, SharpShapesRingAndSmoothOnesDoNot) {
  const Table& shapes = table_named(tables(), "shapes");
  double trailing = 0, pyramid = 0;
  for (std::size_t i = 0; i < shapes.rows(); ++i) {
    if (shapes.number(i, "steps") != 1) continue;
    const double traction = std::abs(shapes.number(i, "traction"));
    const std::string& shape = std::get<std::string>(shapes.at(i, "shape"));
    if (shape == "pulse" && shapes.number(i, "position") < -140) {
      trailing = std::max(trailing, traction);
    }
    if (shape == "pyramid") pyramid = std::max(pyramid, traction);
  }
  EXPECT_GT(trailing, 10);
  EXPECT_LE(pyramid, 1.001);
}

TEST(FractionalPowerStudy, AnEvenNumberOfElementsHasANegativeEigenvalue) {
  const Table& eigenvalues = table_named(tables(), "eigenvalues");
  double odd = 0, even = 0;
  for (std::size_t i = 0; i < eigenvalues.rows(); ++i) {
    const double negative = eigenvalues.number(i, "negative");
    (eigenvalues.number(i, "elements") == 51 ? odd : even) += negative;
    EXPECT_LT(std::hypot(eigenvalues.number(i, "real"), eigenvalues.number(i, "imaginary")), 1);
  }
  EXPECT_EQ(odd, 0);
  EXPECT_EQ(even, 1);
}

// Eigen's method gives no warning: only the residual tells.
TEST(FractionalPowerStudy, TheResidualTellsWhichPowersAreReal) {
  const Table& agreement = table_named(tables(), "agreement");
  for (std::size_t i = 0; i < agreement.rows(); ++i) {
    if (agreement.number(i, "negative_eigenvalue") == 1) {
      EXPECT_GT(agreement.number(i, "schur_residual"), 0.01);
    } else {
      EXPECT_LT(agreement.number(i, "schur_residual"), 1e-9);
      EXPECT_LT(agreement.number(i, "difference"), 1e-9);
    }
  }
}

TEST(FractionalPowerStudy, EdgesStaySharp) {
  const Table& summary = table_named(tables(), "summary");
  const auto error = [&](const std::string& scheme, double distance) {
    return summary.latest({{"scheme", scheme}, {"distance", distance}, {"step_ratio", 0.8}},
                          "error");
  };
  EXPECT_LT(error("fractional", 38.4), 0.4 * error("direct", 38.4));
  EXPECT_LT(error("fractional", 25), error("direct", 25));
}

TEST(FractionalPowerStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()), (std::vector<std::string>{"reproduced", "reproduced", "reproduced",
                                                          "corrected", "reproduced", "reproduced",
                                                          "refuted", "reproduced", "corrected"}));
}

}  // namespace microslip::experiments::fractional_power_test
