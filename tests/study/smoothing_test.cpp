// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/smoothing.hpp"

#include <gtest/gtest.h>

#include "study_tables.hpp"

namespace microslip::experiments::smoothing_test {

constexpr Material material{1, 0.28};

const std::vector<Table>& tables() {
  static const std::vector<Table> all = tables_of("smoothing", read_smoothing, smoothing);
  return all;
}

// The pulses are those after one step. Peaks of c and 1 - c mirror each other.
TEST(SmoothingStudy, PulsesMirrorEachOtherAtOneHalf) {
  const Table& pulses = table_named(tables(), "pulse_summary");
  for (const std::size_t row : {2U, 12U}) {
    EXPECT_EQ(pulses.number(row, "step_ratio"), 0.8);
    EXPECT_EQ(pulses.number(row + 4, "step_ratio"), 0.2);
    EXPECT_NEAR(pulses.number(row, "peak"), pulses.number(row + 4, "peak"), 1e-6);
    EXPECT_NEAR(pulses.number(row, "peak_position"), -1 - pulses.number(row + 4, "peak_position"),
                1e-6);
  }
}

// Phase speed above 1 for c > 1/2 and below for c < 1/2, at all frequencies; c and 1 - c damp one
// step alike.
TEST(SmoothingStudy, AmplificationExplainsTheMotion) {
  const Table& g = table_named(tables(), "amplification");
  for (std::size_t i = 0; i < g.rows(); ++i) {
    const double c = g.number(i, "step_ratio");
    const double speed = g.number(i, "speed");
    EXPECT_LE(g.number(i, "magnitude"), 1 + 1e-6);
    if (c == 0.5 || c == 1) {
      EXPECT_NEAR(speed, 1, 1e-4);
    } else {
      EXPECT_EQ(speed > 1, c > 0.5) << c << ' ' << g.number(i, "frequency");
    }
  }
}

TEST(SmoothingStudy, OnlyWholeStepsKeepThePeakOfTheCase) {
  const Table& summary = table_named(tables(), "summary");
  EXPECT_LT(summary.number(0, "error"), 0.01);
  for (std::size_t row = 1; row < summary.rows(); ++row) {
    EXPECT_GT(summary.number(row, "error"), 1.5 * summary.number(0, "error"));
    EXPECT_GT(summary.number(row, "largest_error"), 0.05);
  }
}

TEST(SmoothingStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()),
            (std::vector<std::string>{"reproduced", "reproduced", "reproduced", "reproduced",
                                      "corrected", "reproduced", "reproduced", "reproduced"}));
}

}  // namespace microslip::experiments::smoothing_test
