// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/kalker_coefficients.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::kalker_coefficients_test {

/// The number in the row of one of the coefficients.
double number(const Table& table, double aspect, double nu, const std::string& name,
              const char* column) {
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.number(i, "aspect") == aspect && table.number(i, "poisson_ratio") == nu &&
        std::get<std::string>(table.at(i, "coefficient")) == name) {
      return table.number(i, column);
    }
  }
  throw std::logic_error("no such row");
}

// A swapped axis of one of the three would show: the methods share no code, and the table was
// printed in 1990.
TEST(KalkerCoefficients, AreThoseOfTwoMethodsAndOfThePrintedTable) {
  const std::vector<Table> found = tables_of(
      "kalker_coefficients", read_kalker_coefficients, kalker_coefficients,
      {"ellipse.aspects=0.2 1 5", "ellipse.poisson_ratios=0 0.25 0.5", "ellipse.elements=14",
       "convergence.aspects=1", "convergence.sizes=5 7", "convergence.rectangles=5 7"});
  const Table& table = table_named(found, "coefficients");
  ASSERT_EQ(table.rows(), 36u);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    EXPECT_LT(table.number(i, "error"), 1e-6) << i;
    EXPECT_LT(table.number(i, "joined"), 2e-4) << i;
    EXPECT_LT(std::abs(table.number(i, "difference")), 0.009) << i;
    EXPECT_NEAR(table.number(i, "units") * table.number(i, "digit") / table.number(i, "value"),
                table.number(i, "difference"), 1e-12)
        << i;
  }
  EXPECT_NEAR(number(table, 1, 0.25, "C11", "value"), 4.112819, 1e-6);
  EXPECT_NEAR(number(table, 1, 0.25, "C22", "value"), 3.668295, 1e-6);
  EXPECT_NEAR(number(table, 1, 0.25, "C23", "value"), 1.466109, 1e-6);
  EXPECT_NEAR(number(table, 1, 0.25, "C33", "value"), 1.184303, 1e-6);
  // 9.79 is printed in the place of 9.868.
  EXPECT_NEAR(number(table, 5, 0.5, "C22", "units"), -7.83, 0.005);
}

TEST(KalkerCoefficients, Verdicts) {
  const std::vector<Table> found =
      tables_of("kalker_coefficients", read_kalker_coefficients, kalker_coefficients,
                {"ellipse.aspects=0.1 0.5 0.8 1 1.25 5 10", "ellipse.poisson_ratios=0 0.5",
                 "ellipse.elements=14", "convergence.rectangles=14 28"});
  EXPECT_EQ(verdicts(found), std::vector<std::string>(12, "ours"));
}

}  // namespace microslip::experiments::kalker_coefficients_test
