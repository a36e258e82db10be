// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/support/not_converged.hpp"

namespace microslip::quadrature_test {

TEST(Quadrature, TakesSingularEnds) {
  EXPECT_NEAR(integrate([](double x) { return 1 / std::sqrt(x); }, 0, 4, 1e-13), 4, 1e-12);
  EXPECT_NEAR(integrate([](double x) { return std::log(x); }, 0, 1, 1e-13), -1, 1e-13);
}

TEST(Quadrature, SaysWhereItFails) {
  const auto diverging = [](double x) { return 1 / x; };
  const auto jumping = [](double x) { return std::sin(1 / x) > 0 ? 1.0 : 0.0; };
  EXPECT_THROW(integrate(diverging, 0, 1, 1e-10), NotConverged);
  EXPECT_THROW(integrate(jumping, 0, 1, 1e-13), NotConverged);
  // Nothing but rounding is left of the integral, which has no relative accuracy.
  const auto cancelling = [](double x) { return std::sin(x); };
  EXPECT_THROW(integrate(cancelling, 0, 2 * std::numbers::pi, 1e-13), NotConverged);
}

}  // namespace microslip::quadrature_test
