// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/full_sliding.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace microslip {
namespace {

TEST(FullSliding, RefusesTables) {
  const TabulatedBound table(1, Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1));
  EXPECT_THROW(FullSliding(PlaneKernel({1, 0.28}, 10), table), std::invalid_argument);
}

}  // namespace
}  // namespace microslip
