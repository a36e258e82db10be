// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/wiggle_spectrum.hpp"

#include <gtest/gtest.h>

#include "microslip/halfspace/basis.hpp"

namespace microslip::experiments {
namespace {

constexpr Material material{1, 0.28};

Table matrix_for(const char* basis, double step_ratio) {
  return wiggle_spectrum({.kernel = PlaneKernel(material, 1),
                          .shape = make_basis(basis).shapes().front(),
                          .spacing = 1,
                          .elements = 31,
                          .step_ratios = {step_ratio},
                          .samples = 10,
                          .strip_widths = {40}},
                         [](std::size_t, std::size_t) {})[0];
}

/// Changes of sign down the middle column of the inverse, of at most 30.
int sign_changes_of_inverse(const Table& matrix) {
  int changes = 0;
  double previous = 0;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    if (matrix.number(i, "column") != 16) continue;
    const double entry = matrix.number(i, "inverse");
    changes += entry * previous < 0;
    previous = entry;
  }
  return changes;
}

// Thesis Figs. 6.1 and 6.2, 6.4 and 6.5.
TEST(WiggleSpectrum, TheInverseAlternatesForSmallStepsOnly) {
  for (const char* basis : {"constant", "linear"}) {
    EXPECT_EQ(sign_changes_of_inverse(matrix_for(basis, 1)), 1) << basis;
    EXPECT_GE(sign_changes_of_inverse(matrix_for(basis, 0.01)), 28) << basis;
  }
}

// Computed independently: plane strain 0.394003; strips of nu = 0.28, 0.393923 at Dy = 40 dx and
// 0.296508 at Dy = dx. The thesis's 0.3939 is 39/99, the nearest of 100 samples.
TEST(WiggleSpectrum, DiagonalAndLowerEntryCrossAt0p394) {
  const ShapeFunction shape = constant_shape();
  EXPECT_NEAR(diagonal_crossing(PlaneKernel(material, 1), shape, 1), 0.394003, 5e-7);
  EXPECT_NEAR(diagonal_crossing(StripKernel(material, 40), shape, 1), 0.393923, 5e-7);
  EXPECT_NEAR(diagonal_crossing(StripKernel(material, 1), shape, 1), 0.296508, 5e-7);
}

TEST(WiggleSpectrum, TheCrossingDoesNotDependOnUnits) {
  const ShapeFunction shape = constant_shape();
  EXPECT_NEAR(diagonal_crossing(StripKernel({80000, 0.28}, 0.4), shape, 0.01),
              diagonal_crossing(StripKernel({1, 0.28}, 40), shape, 1), 1e-12);
}

TEST(WiggleSpectrum, DiagonalsSpanTheStepsUpToOne) {
  const auto tables = wiggle_spectrum({.kernel = PlaneKernel(material, 1),
                                       .shape = constant_shape(),
                                       .spacing = 1,
                                       .elements = 3,
                                       .step_ratios = {1},
                                       .samples = 100,
                                       .strip_widths = {40}},
                                      [](std::size_t, std::size_t) {});
  ASSERT_EQ(tables[1].rows(), 100U);
  EXPECT_EQ(tables[1].number(99, "step_ratio"), 1);
  EXPECT_NEAR(tables[1].number(99, "m11"), -tables[1].number(99, "m12"), 1e-15);  // thesis 6.1
  EXPECT_LT(tables[1].number(0, "m11_scaled"), 0.05);
  EXPECT_EQ(tables[2].rows(), 2U);
}

}  // namespace
}  // namespace microslip::experiments
