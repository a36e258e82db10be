// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/load_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace microslip::load_response_test {

using Complex = std::complex<double>;
using std::numbers::pi;

// Figures that were found by two other methods, to the digits shown.
TEST(LoadResponse, HasKnownFigures) {
  const auto expect = [](double wavelength, const Complex& expected) {
    EXPECT_NEAR(std::abs(force_by_normal_load(2 * pi / wavelength, 0.6, 10) - expected), 0, 1e-10);
  };
  expect(1, {-0.1482830366, 0.0188789107});
  expect(5, {-0.1429511793, 0.0961156072});
  expect(10, {-0.2280377607, 0.1458902149});
  expect(100, {-0.3962349435, 0.0332050117});
}

TEST(LoadResponse, HasItsLimits) {
  for (const double stick_ratio : {0.05, 0.6, 0.99, 1.0}) {
    EXPECT_NEAR(std::abs(force_by_normal_load(1e-9, stick_ratio, 10) + (1 - stick_ratio)), 0, 1e-7);
    const double fast = -(1 - std::log(20) / std::log(20 / stick_ratio));
    EXPECT_NEAR(std::abs(force_by_normal_load(1e4, stick_ratio, 10) - fast), 0, 5e-3);
  }
  EXPECT_TRUE(std::isfinite(std::abs(force_by_normal_load(2.404825557695773, 1, 10))));
}

TEST(LoadResponse, RefusesWhatIsNone) {
  EXPECT_THROW(force_by_normal_load(0, 0.5, 10), std::invalid_argument);
  EXPECT_THROW(force_by_normal_load(1, 0, 10), std::invalid_argument);
  EXPECT_THROW(force_by_normal_load(1, 1.1, 10), std::invalid_argument);
  EXPECT_THROW(force_by_normal_load(1, 0.5, 0.5), std::invalid_argument);
}

}  // namespace microslip::load_response_test
