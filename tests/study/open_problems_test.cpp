// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/open_problems.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/rolling/schemes.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::open_problems_test {

const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("open_problems", read_open_problems, open_problems,
                {"grid.sizes=15 30 60 120 240", "cases.number=12", "steady.elements=60",
                 "steady.step_ratios=1e-12 1e-3 0.1 1 1000", "motion.refinement=4",
                 "motion.step_ratios=2.5 1 0.9 0.75 0.5 0.31 0.1 0.01", "curve.widths=1 5",
                 "curve.points=20", "curve.unknowns=4 8 16 28 40"});
  return all;
}

double of(const char* table, const char* scheme, const char* column) {
  return table_named(tables(), table).latest({{"scheme", scheme}}, column);
}

TEST(OpenProblemsStudy, OrdersAreThoseOfTheLeadingEdge) {
  EXPECT_NEAR(of("orders", "standard", "force_order"), 1, 0.05);
  EXPECT_NEAR(of("orders", "known_edge", "force_order"), 1.5, 0.1);
  EXPECT_NEAR(of("orders", "calibrated", "force_order"), 2, 0.25);
  EXPECT_LT(of("orders", "known_edge", "force_reduction"), 1.5);
}

TEST(OpenProblemsStudy, OrdersAreThoseOfTheCatalogue) {
  for (const SteadyEntry& entry : steady_schemes()) {
    const std::string name(entry.name);
    if (std::isfinite(entry.order)) {
      EXPECT_NEAR(of("orders", name.c_str(), "force_order"), entry.order, 0.25) << name;
    }
  }
}

TEST(OpenProblemsStudy, InversionIsExact) {
  EXPECT_LT(of("errors", "inversion", "force_largest"), 1e-12);
  EXPECT_LT(of("errors", "inversion", "mean_largest"), 1e-12);
  EXPECT_GT(of("errors", "standard", "force_median"), 1e-3);
  EXPECT_GT(of("errors", "known_edge", "force_largest"), 3e-5);
}

TEST(OpenProblemsStudy, SteadyRollingHasNoStep) {
  const Table& steps = table_named(tables(), "steady_steps");
  int found = 0;
  for (std::size_t i = 0; i < steps.rows(); ++i) {
    if (std::get<std::string>(steps.at(i, "scheme")) != "inversion") continue;
    EXPECT_LT(steps.number(i, "force_error"), 1e-12);
    ++found;
  }
  EXPECT_EQ(found, 5);
}

// 50 elements rolled on 147 elements.
TEST(OpenProblemsStudy, RememberedStepsOfAnyLengthGiveTheSame) {
  const Table& steps = table_named(tables(), "steps");
  const auto value = [&](const char* scheme, double c, const char* column) {
    return steps.latest({{"scheme", scheme}, {"step_ratio", c}}, column);
  };
  for (const double c : {2.5, 0.9, 0.75, 0.5, 0.31, 0.1, 0.01}) {
    EXPECT_LT(value("remembered", c, "from_unit_step"), 1e-3) << c;
    EXPECT_LE(value("remembered", c, "turning_points"), value("remembered", 1, "turning_points"))
        << c;
    EXPECT_LE(value("remembered", c, "total_variation"),
              value("remembered", 1, "total_variation") + 1e-9)
        << c;
  }
  for (const double c : {0.9, 0.75, 0.31, 0.1, 0.01}) {
    EXPECT_GT(value("direct", c, "error"), 3 * value("remembered", c, "error")) << c;
    EXPECT_LT(value("relaxed", c, "peak"), value("remembered", c, "peak")) << c;
  }
}

TEST(OpenProblemsStudy, FortyUnknownsGiveTwelveDigits) {
  const Table& digits = table_named(tables(), "digits");
  for (const double width : {1.0, 5.0, HUGE_VAL}) {
    EXPECT_LT(digits.latest({{"width", width}, {"unknowns", 40.0}}, "largest_error"), 1e-12)
        << width;
  }
  EXPECT_GT(digits.latest({{"width", 1.0}, {"unknowns", 8.0}}, "largest_error"), 1e-4);
}

TEST(OpenProblemsStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()),
            (std::vector<std::string>{"corrected", "reproduced", "corrected", "reproduced"}));
}

}  // namespace microslip::experiments::open_problems_test
