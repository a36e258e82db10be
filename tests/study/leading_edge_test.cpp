// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/leading_edge.hpp"

#include <gtest/gtest.h>

#include "study_tables.hpp"

namespace microslip::experiments::leading_edge_test {

// A part of the study's settings, with those that come nearest to the thesis's numbers.
const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("leading_edge", read_leading_edge, leading_edge,
                {"grid.leading_offsets=0.1 0.3 0.5 0.7 1", "grid.trailing_offsets=0 0.25 1",
                 "load.stick_ratios=0.3 0.5 0.6 0.9"});
  return all;
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
