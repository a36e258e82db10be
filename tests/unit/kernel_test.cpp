// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace microslip::kernel_test {

constexpr Material material{3, 0.28};

template <class K>
void expect_decay_is_minus_the_derivative(const K& kernel) {
  for (const double z : {0.01, 0.5, 2.0, 30.0}) {
    const double h = 1e-4 * z;
    const double slope = (kernel.displacement(z + h) - kernel.displacement(z - h)) / (2 * h);
    EXPECT_NEAR(kernel.decay(z), -slope, 1e-7 * kernel.decay(z)) << z;
  }
}

TEST(StripKernel, DecayIsMinusTheDerivative) {
  expect_decay_is_minus_the_derivative(StripKernel(material, 1.3));
}

TEST(PlaneKernel, DecayIsMinusTheDerivative) {
  expect_decay_is_minus_the_derivative(PlaneKernel(material, 1.3));
}

// The strip tends to plane strain with L0 = Dy exp(nu / (1 - nu)), as Dy^-2.
TEST(StripKernel, TendsToPlaneStrainAsTheSquareOfItsWidth) {
  const auto gap = [](double width) {
    const double length = width * std::exp(material.poisson_ratio / (1 - material.poisson_ratio));
    return StripKernel(material, width).displacement(1) -
           PlaneKernel(material, length).displacement(1);
  };
  for (const double width : {20.0, 40.0, 80.0}) {
    EXPECT_NEAR(std::log2(gap(width) / gap(2 * width)), 2, 0.01);
  }
}

TEST(Kernel, RejectsWhatIsOutsideItsRange) {
  EXPECT_THROW(StripKernel({1, 0.28}, 0), std::invalid_argument);
  EXPECT_THROW(StripKernel({1, 0.28}, -1), std::invalid_argument);
  EXPECT_THROW(StripKernel({0, 0.28}, 1), std::invalid_argument);
  EXPECT_THROW(PlaneKernel({1, 0.51}, 1), std::invalid_argument);
  EXPECT_THROW(PlaneKernel({1, 0.28}, std::nan("")), std::invalid_argument);
  EXPECT_THROW(PlaneKernel({1, 0.28}, INFINITY), std::invalid_argument);
}

}  // namespace microslip::kernel_test
