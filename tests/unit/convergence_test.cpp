// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace microslip::convergence_test {

TEST(FittedOrder, IsTheExponent) {
  const std::vector<double> sizes = {10, 30, 70};
  std::vector<double> errors;
  for (const double n : sizes) errors.push_back(-3 * std::pow(n, -1.5));
  EXPECT_NEAR(fitted_order(sizes, errors), 1.5, 1e-13);
}

TEST(FittedOrder, RejectsWhatHasNoSlope) {
  using V = std::vector<double>;
  EXPECT_THROW(fitted_order(V{10}, V{1}), std::invalid_argument);
  EXPECT_THROW(fitted_order(V{10, 20}, V{1}), std::invalid_argument);
  EXPECT_THROW(fitted_order(V{10, 10}, V{1, 2}), std::invalid_argument);
  EXPECT_THROW(fitted_order(V{10, 20}, V{1, 0}), std::invalid_argument);
}

}  // namespace microslip::convergence_test
