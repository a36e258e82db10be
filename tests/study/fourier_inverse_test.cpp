// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fourier_inverse.hpp"

#include <gtest/gtest.h>

#include "microslip/support/convergence.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::fourier_inverse_test {

const std::vector<Table>& tables() {
  static const std::vector<Table> all = tables_of("fourier_inverse", read_fourier_inverse,
                                                  fourier_inverse, {"grid.sizes=16 32 64 128 256"});
  return all;
}

// Away from the boundary the error is a constant from the zero frequency, whatever the size;
// without it, it falls with first order.
TEST(FourierInverse, ConvergesAwayFromTheBoundaryOnlyWithoutTheZeroFrequency) {
  const Table& errors = tables()[2];
  for (const std::size_t first : {0U, 10U}) {  // c = 1, constant and linear
    std::vector<double> sizes, with, without;
    for (std::size_t i = first; i < first + 5; ++i) {
      EXPECT_EQ(errors.number(i, "step_ratio"), 1);
      sizes.push_back(errors.number(i, "elements"));
      with.push_back(errors.number(i, "without_boundary"));
      without.push_back(errors.number(i, "without_mean"));
    }
    EXPECT_NEAR(fitted_order(sizes, with), 0, 0.05);
    EXPECT_NEAR(fitted_order(sizes, without), 1, 0.05);
  }
}

TEST(FourierInverse, ReciprocalsAreThoseOfTheCoefficients) {
  const Table& coefficients = tables()[0];
  ASSERT_EQ(coefficients.rows(), 2U * 2 * 60);
  for (const std::size_t row : {1U, 30U, 100U}) {
    EXPECT_NEAR(coefficients.number(row, "magnitude") * coefficients.number(row, "reciprocal"), 1,
                1e-14);
  }
}

TEST(FourierInverse, Verdicts) {
  EXPECT_EQ(verdicts(tables()), (std::vector<std::string>{"reproduced", "reproduced", "reproduced",
                                                          "corrected", "refuted"}));
}

}  // namespace microslip::experiments::fourier_inverse_test
