// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/sine.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace microslip::sine_test {

TEST(XMinusSine, KeepsItsDigits) {
  for (const double x : {1e-9, 1e-4, 1e-2}) {
    const double series = x * x * x / 6 * (1 - x * x / 20 * (1 - x * x / 42 * (1 - x * x / 72)));
    EXPECT_NEAR(x_minus_sine(x) / series, 1, 1e-15) << x;
    EXPECT_EQ(x_minus_sine(-x), -x_minus_sine(x));
  }
  for (const double x : {1.4, 1.6, 3.0, 6.2}) {
    EXPECT_NEAR(x_minus_sine(x) / (x - std::sin(x)), 1, 1e-15) << x;
  }
}

}  // namespace microslip::sine_test
