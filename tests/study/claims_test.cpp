// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::claims_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string verdict_of(const Range& range, double measured) {
  return verdict(holds_if({range}), measured);
}

TEST(Rules, OneBoundIsNotAccepted) {
  EXPECT_EQ(verdict_of(above(5), 5), "refuted");
  EXPECT_EQ(verdict_of(above(5), std::nextafter(5, 6)), "reproduced");
  EXPECT_EQ(verdict_of(above(5), infinity), "reproduced");
  EXPECT_EQ(verdict_of(below(-0.5), -0.5), "refuted");
  EXPECT_EQ(verdict_of(below(-0.5), std::nextafter(-0.5, -1)), "reproduced");
  EXPECT_EQ(sentence(holds_if({above(5)})),
            "reproduced if the measured value is above 5; otherwise refuted");
  EXPECT_TRUE(std::isnan(tolerance(holds_if({above(5)}))));
}

TEST(Rules, RangesOfTwoBounds) {
  EXPECT_EQ(verdict_of(between(1.5, 2.1), 1.5), "refuted");
  EXPECT_EQ(verdict_of(between(1.5, 2.1), 1.51), "reproduced");
  EXPECT_EQ(verdict_of(between(1.5, 2.1), 2.1), "refuted");
  EXPECT_EQ(verdict_of(within(0.25, 1), 0.75), "reproduced");
  EXPECT_EQ(verdict_of(within(0.25, 1), 1.25), "reproduced");
  EXPECT_EQ(verdict_of(within(0.25, 1), 1.26), "refuted");
  EXPECT_EQ(verdict_of(within(0.25, 1), 0.74), "refuted");
  EXPECT_EQ(verdict_of(equal_to(1), 1), "reproduced");
  EXPECT_EQ(verdict_of(equal_to(1), std::nextafter(1, 2)), "refuted");
  EXPECT_EQ(sentence(holds_if({within(0.1, 0.55)})),
            "reproduced if the measured value is within 0.1 of 0.55; otherwise refuted");
  EXPECT_EQ(tolerance(holds_if({within(0.1, 0.55)})), 0.1);
  EXPECT_NEAR(tolerance(holds_if({between(1.5, 2.1)})), 0.3, 1e-15);
}

TEST(Rules, CorrectWhatTheyDoNotRefute) {
  const Rule rule = corrected_if({below(1e-3)}, "reproduced");
  EXPECT_EQ(verdict(rule, 1e-4), "corrected");
  EXPECT_EQ(verdict(rule, 1), "reproduced");
  EXPECT_EQ(sentence(rule), "corrected if the measured value is below 0.001; otherwise reproduced");
}

TEST(Rules, PercentAreOfTheNumber) {
  const Range range = within_percent(5, -2);
  EXPECT_EQ(verdict_of(range, -2.09), "reproduced");
  EXPECT_EQ(verdict_of(range, -2.11), "refuted");
  EXPECT_EQ(verdict_of(range, -1.89), "refuted");
  EXPECT_EQ(range.words, "is within 5 % of -2");
  EXPECT_NEAR(range.tolerance, 0.1, 1e-15);
}

TEST(Rules, AllConditionsMustHold) {
  const auto rule = [](double other) {
    return holds_if({above(5), {"the number at the largest c", other, equal_to(1)}});
  };
  EXPECT_EQ(verdict(rule(1), 6), "reproduced");
  EXPECT_EQ(verdict(rule(2), 6), "refuted");
  EXPECT_EQ(verdict(rule(1), 4), "refuted");
  EXPECT_EQ(sentence(rule(1)),
            "reproduced if the measured value is above 5 and the number at the largest c is 1; "
            "otherwise refuted");
}

TEST(Rules, TheFirstRulingThatHoldsIsTheVerdict) {
  const Rule rule = holds_if({within(0.1, 2)}, {{"the nearest of all", 2.05, within(0.1, 2)}});
  EXPECT_EQ(verdict(rule, 2), "reproduced");
  EXPECT_EQ(verdict(rule, 3), "corrected");
  EXPECT_EQ(verdict(holds_if({above(3)}, {above(2)}), 1), "refuted");
  EXPECT_EQ(sentence(rule),
            "reproduced if the measured value is within 0.1 of 2; corrected if the nearest of all "
            "is within 0.1 of 2; otherwise refuted");
  EXPECT_EQ(verdict(ours_if({below(1)}), 0), "ours");
  EXPECT_EQ(verdict(ours_if({below(1)}), 1), "refuted");
}

TEST(Rules, NothingMeasuredIsNothingToCompare) {
  EXPECT_EQ(verdict(holds_if({above(5)}), not_given), "not_comparable");
  EXPECT_EQ(verdict(holds_if({above(5), {"another", not_given, below(1)}}), 6), "not_comparable");
  EXPECT_EQ(verdict(holds_if({above(5)}, {{"another", not_given, below(1)}}), 6), "not_comparable");
  const Rule rule = not_comparable("the thesis does not say at which N");
  EXPECT_EQ(verdict(rule, 1), "not_comparable");
  EXPECT_EQ(sentence(rule), "not comparable: the thesis does not say at which N");
  EXPECT_TRUE(std::isnan(tolerance(rule)));
}

Claim claim_with(const Rule& rule) {
  return {"a statement", "1", 2, 2.01, "1", rule, "a number", no_figure};
}

TEST(Claims, ShowTheirRule) {
  const Table table = claims_table({claim_with(holds_if({within(0.1, 2)}))});
  EXPECT_EQ(std::get<std::string>(table.at(0, "rule")),
            "reproduced if the measured value is within 0.1 of 2; otherwise refuted");
  EXPECT_EQ(table.number(0, "tolerance"), 0.1);
  EXPECT_EQ(verdicts({table}), std::vector<std::string>{"reproduced"});
}

TEST(Claims, WithoutARuleAreNone) {
  EXPECT_THROW(claims_table({claim_with({})}), std::logic_error);
  EXPECT_THROW(claims_table({claim_with({.rulings = {}, .otherwise = "reproduced"})}),
               std::logic_error);
  EXPECT_THROW(claims_table({claim_with(holds_if({}))}), std::logic_error);
  EXPECT_THROW(claims_table({claim_with({.rulings = {{"likely", {above(1)}}}, .otherwise = ""})}),
               std::logic_error);
}

TEST(Claims, OfARunWithOtherParametersAreNotJudged) {
  Table other("claims of others", "no verdicts", {{"verdict", "1", "of another kind"}});
  other.add({"stays"});
  const std::vector<Table> tables{other, claims_table({claim_with(holds_if({above(1)}))})};
  EXPECT_EQ(verdicts(judged_unless_changed(tables, {})), std::vector<std::string>{"reproduced"});
  const auto bare = judged_unless_changed(tables, {"load.creepage", "grid.elements"});
  EXPECT_EQ(verdicts(bare), std::vector<std::string>{"not_judged"});
  EXPECT_EQ(std::get<std::string>(bare[0].at(0, "verdict")), "stays");
  EXPECT_EQ(bare[1].number(0, "measured_value"), 2.01);
  std::ostringstream text;
  bare[1].write(text, "study", {});
  EXPECT_NE(text.str().find("; not judged: this run has other parameters than the study: "
                            "load.creepage, grid.elements\n"),
            std::string::npos);
}

}  // namespace microslip::experiments::claims_test
