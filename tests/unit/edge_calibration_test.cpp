// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/edge_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/halfspace/leading_edge.hpp"

namespace microslip::edge_calibration_test {

// The limits are those of Wiener-Hopf theory.
TEST(CalibratedOffset, TendsToThatOfTheUnboundedGrid) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const double limit = leading_edge_constants(basis).offset;
    const double coarse = calibrated_offset(basis, 100) - limit;
    const double fine = calibrated_offset(basis, 400) - limit;
    EXPECT_LT(std::abs(fine), 2e-4);
    EXPECT_NEAR(coarse / fine, 4, 0.05);  // first order
  }
}

TEST(CalibratedOffset, IsTheSameByFactors) {
  const Solver dense{.type = Solver::Type::dense};
  const Solver fft{.type = Solver::Type::fft};
  EXPECT_NEAR(calibrated_offset(constant_basis(), 150, dense),
              calibrated_offset(constant_basis(), 150, fft), 1e-11);
}

}  // namespace microslip::edge_calibration_test
