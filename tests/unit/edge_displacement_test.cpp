// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/thesis/edge_displacement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/support/not_converged.hpp"
#include "microslip/support/quadrature.hpp"

namespace microslip::edge_displacement_test {

constexpr Material material{3, 0.28};

TEST(EdgeDisplacement, ReversesWithTheCreepage) {
  const PlaneKernel kernel(material, 1);
  const HertzBound bound(1, 1);
  EXPECT_EQ(edge_displacement(kernel, Carter::from_creepage(material, bound, 0.1)),
            -edge_displacement(kernel, Carter::from_creepage(material, bound, -0.1)));
}

TEST(Quadrature, SaysWhereItFails) {
  EXPECT_NEAR(integrate([](double x) { return std::log(x); }, 0, 1, 1e-12), -1, 1e-12);
  EXPECT_THROW(integrate([](double x) { return 1 / x; }, 0, 1, 1e-12), NotConverged);
}

}  // namespace microslip::edge_displacement_test
