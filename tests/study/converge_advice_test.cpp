// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../experiments/src/converge_advice.hpp"

#include <gtest/gtest.h>

namespace microslip::experiments::converge_advice_test {

/// Errors 1/N and 1/N^2; the one takes half the time.
const std::vector<Candidate> candidates = {
    {"one", 10, 0.1, 1e-3, 10, 0.2e-3},      {"one", 100, 0.01, 10e-3, 10, 2e-3},
    {"one", 1000, 1e-3, 0.1, 10, 20e-3},     {"two", 10, 0.01, 2e-3, 10, 0.4e-3},
    {"two", 100, 1e-4, 20e-3, 10, 4e-3},     {"by_chance", 10, 1e-5, 1e-4, 10, 1e-3},
    {"by_chance", 100, 0.2, 1e-3, 10, 1e-2}, {"exact", 10, 1e-16, 12.3, 10, 9}};

std::string advised(double error, std::optional<double> step_time = std::nullopt,
                    double reference_error = 0) {
  const Table table = advice(candidates, {.error = error,
                                          .step_time = step_time,
                                          .quantity = "force",
                                          .steady = false,
                                          .reference_error = reference_error});
  return std::get<std::string>(table.at(step_time ? 1 : 0, "advice"));
}

TEST(Advice, TakesTheCheapestThatIsAccurateFromAnNumberOn) {
  EXPECT_EQ(advised(0.01),
            "for an error of 0.01 in the force: two with grid.elements 10 (error 0.01), 2 ms, 200 "
            "us a step; then one with grid.elements 100 (error 0.01), 10 ms, exact with "
            "grid.elements 10 (error below 1e-9), 12 s; not by by_chance");
  EXPECT_EQ(advised(5e-4),
            "for an error of 5e-04 in the force: two with grid.elements 100 (error 0.0001), 20 ms, "
            "2 ms a step; then exact with grid.elements 10 (error below 1e-9), 12 s; not by one, "
            "by_chance");
}

TEST(Advice, DoesNotTrustAReferenceThatIsOff) {
  EXPECT_EQ(
      advised(0.01, std::nullopt, 0.004),
      "for an error of 0.01 in the force: the reference itself may be 0.004 off, more elements "
      "are needed");
}

TEST(Advice, TakesTheMostAccurateWithinATime) {
  EXPECT_EQ(advised(0.01, 5e-3),
            "within 5 ms a step: by_chance with grid.elements 10 (error 1e-05), 10 us on average, "
            "the longest 1 ms");
  EXPECT_EQ(advised(0.01, 0.3e-3),
            "within 300 us a step: one with grid.elements 10 (error 0.1), 100 us on average, the "
            "longest 200 us");
  EXPECT_EQ(advised(0.01, 1e-4), "within 100 us a step: none of these");
}

}  // namespace microslip::experiments::converge_advice_test
