// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/basis.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace microslip {
namespace {

TEST(Basis, ValuesOfTheHat) {
  const Basis hat = linear_basis();
  EXPECT_DOUBLE_EQ(hat.value(0), 1);
  EXPECT_DOUBLE_EQ(hat.value(-0.25), 0.75);
  EXPECT_DOUBLE_EQ(hat.value(0.75), 0.25);
  EXPECT_DOUBLE_EQ(hat.value(1.5), 0);
}

TEST(Basis, ShiftedFunctionsAddUpToOne) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    for (const double s : {0.1, 0.3, 0.49, 0.8}) {
      double sum = 0;
      for (int k = -2; k <= 2; ++k) sum += basis.value(s - k);
      EXPECT_DOUBLE_EQ(sum, 1) << basis.name();
    }
    EXPECT_DOUBLE_EQ(basis.weight(), 1);
  }
}

TEST(Basis, IntegralsOfAQuadraticAreExact) {
  const Basis parabola("parabola", {{-1, 1, {1, 0, -1}}});  // 1 - s^2
  const auto antiderivative = [](double s) { return s - s * s * s / 3; };
  EXPECT_DOUBLE_EQ(parabola.integral(-0.5, 0.75), antiderivative(0.25) - antiderivative(-0.5));
  EXPECT_DOUBLE_EQ(parabola.integral(-3, 10), 4.0 / 3);
  EXPECT_DOUBLE_EQ(parabola.integral(1, 2), 0);
}

TEST(Basis, IntegralsAcrossPiecesAreExact) {
  EXPECT_DOUBLE_EQ(linear_basis().integral(-0.5, 1), 0.75);
  EXPECT_DOUBLE_EQ(constant_basis().integral(0.25, 5), 0.25);
}

TEST(Basis, ShortIntegralsKeepTheirDigits) {
  EXPECT_DOUBLE_EQ(linear_basis().integral(0.25, 1e-12), (0.75 - 0.5e-12) * 1e-12);
}

TEST(Basis, RejectsAnUnknownName) { EXPECT_THROW(make_basis("cubic"), std::invalid_argument); }

}  // namespace
}  // namespace microslip
