// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "microslip/friction/sliding_field.hpp"

namespace microslip::full_sliding_test {

TEST(SlidingField, RefusesTables) {
  const TabulatedBound table(1, Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1));
  EXPECT_THROW(SlidingField(PlaneKernel({1, 0.28}, 10), table), std::invalid_argument);
}

}  // namespace microslip::full_sliding_test
