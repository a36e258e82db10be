// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/leading_edge.hpp"

#include <gtest/gtest.h>

#include "study_tables.hpp"

namespace microslip::experiments::leading_edge_test {

// A part of the study's settings, with those that come nearest to the thesis's numbers.
const std::vector<Table>& tables() {
  static const std::vector<Table> found = leading_edge({.material = {1, 0.28},
                                                        .length = 200,
                                                        .bound = HertzBound(1, 1),
                                                        .sizes = {15, 30, 60, 120, 240},
                                                        .leading_offsets = {0.1, 0.3, 0.5, 0.7, 1},
                                                        .trailing_offsets = {0, 0.25, 1},
                                                        .stick_ratios = {0.3, 0.5, 0.6, 0.9},
                                                        .profile_elements = 15,
                                                        .profile_stick_ratio = 0.6,
                                                        .profile_offset = 0.4},
                                                       [](std::size_t, std::size_t) {});
  return found;
}

const Table& table(const std::string& name) { return table_named(tables(), name); }

TEST(LeadingEdge, Verdicts) {
  EXPECT_EQ(
      verdicts(tables()),
      (std::vector<std::string>{"reproduced", "reproduced", "reproduced", "reproduced", "corrected",
                                "corrected", "not_comparable", "reproduced", "reproduced"}));
}

TEST(LeadingEdge, MedianReductionsAreFirstOrderAndThreeHalves) {
  const Table& summary = table("summary");
  for (const std::size_t standard : {0U, 1U, 4U, 5U}) {
    EXPECT_NEAR(summary.number(standard, "median"), 2, 0.15);
  }
  for (const std::size_t known : {2U, 3U}) {
    EXPECT_NEAR(summary.number(known, "median"), 2.75, 0.15);
  }
}

TEST(LeadingEdge, TheEdgeFunctionIsUsedOnlyWhereItsElementEndsAtTheEdge) {
  EXPECT_EQ(table("summary").number(5, "settings"), 3.0 * 4);
  EXPECT_EQ(table("summary").number(0, "settings"), 5.0 * 3 * 4);
}

}  // namespace microslip::experiments::leading_edge_test
