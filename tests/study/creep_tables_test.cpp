// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/creep_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::creep_tables_test {

std::vector<Table> found_with(const std::vector<std::string>& settings) {
  return tables_of("creep_tables", read_creep_tables, creep_tables, settings);
}

/// Few states, and references on few cells: errors that are judged are larger than those of references.
const std::vector<Table>& few_states() {
  static const std::vector<Table> found =
      found_with({"random.shapes=3", "random.states=8", "contact.every=8", "reference.cells=10",
                  "reference.fine_cells=13", "reference.fine_shapes=1", "reference.fine_states=4",
                  "usetab.cells=8"});
  return found;
}

double error_of(const char* method, const char* set, const char* column) {
  return table_named(few_states(), "errors").latest({{"method", method}, {"set", set}}, column);
}

// The motions of CONTACT's cases are scaled by Hertz's theory, and its results are of another program:
// a wrong sign or scale would be an error of the order of 1. On 11 x 11 elements, 41 to 49 of which are in
// contact, CONTACT is off by some percent.
TEST(CreepTables, CasesAreThoseOfContact) {
  for (const char* column : {"force_rms", "lateral_force_rms", "spin_moment_rms"}) {
    EXPECT_LT(error_of("contact", "contact", column), 0.04) << column;
    EXPECT_GT(error_of("contact", "contact", column), 0.003) << column;
  }
  EXPECT_LT(error_of("contact", "contact", "lateral_force_largest"), 0.25);
}

// Cases of a/b = 0.2 ... 5, three spins and seven directions of the creepage, and four directions without
// spin: the magnitudes 1.1 and 5 times the unit, and with spin 0 once.
TEST(CreepTables, CasesAreCountedOnce) {
  const Table& states = table_named(few_states(), "states");
  std::size_t contact = 0;
  for (std::size_t i = 0; i < states.rows(); ++i) {
    if (std::get<std::string>(states.at(i, "set")) != "contact") continue;
    ++contact;
    const double ratio = states.number(i, "ratio");
    EXPECT_TRUE(ratio == 0.2 || ratio == 0.5 || ratio == 1 || ratio == 2 || ratio == 5) << ratio;
  }
  EXPECT_EQ(contact, 5U * (2 * (4 + 3 * 7) + 3));
}

// Where c/rho is printed: 9/2700 on the circle with p0 = 3 G/(2 pi 81).
TEST(CreepTables, MotionsOfCasesFollowFromPrintedRadii) {
  const Table& states = table_named(few_states(), "states");
  const double pi = std::acos(-1.0), strain = 3 / (2 * pi * 81);
  double most = 0, spin = 0;
  for (std::size_t i = 0; i < states.rows(); ++i) {
    if (std::get<std::string>(states.at(i, "set")) != "contact") continue;
    if (states.number(i, "ratio") != 1) continue;
    most = std::max(most, states.number(i, "creepage"));
    spin = std::max(spin, states.number(i, "spin"));
  }
  EXPECT_NEAR(most, 5 * 9 / 2700. / strain, 1e-9 * most);
  EXPECT_NEAR(spin, 2 * 9 / 2700. / strain, 1e-9 * spin);
}

// A table of the same method shows errors of its nodes; no installed table is worse than this.
TEST(CreepTables, ReferencesAreThoseOfTheTable) {
  EXPECT_LT(error_of("table", "all", "force_rms"), 5e-3);
  EXPECT_LT(error_of("table", "all", "lateral_force_rms"), 5e-3);
  EXPECT_LT(error_of("table", "all", "spin_moment_rms"), 5e-3);
}

TEST(CreepTables, TimesAreMeasured) {
  const Table& times = table_named(few_states(), "cost_timing");
  ASSERT_EQ(times.rows(), 9U);
  for (std::size_t i = 0; i < times.rows(); ++i) {
    if (std::get<std::string>(times.at(i, "method")) == "contact") {
      EXPECT_TRUE(std::isnan(times.number(i, "time")));
    } else {
      EXPECT_GT(times.number(i, "time"), 1e-9);
      EXPECT_LT(times.number(i, "time"), 1);
    }
  }
}

TEST(CreepTables, DistributionsFall) {
  const Table& distribution = table_named(few_states(), "distribution");
  for (std::size_t i = 1; i < distribution.rows(); ++i) {
    if (distribution.at(i, "method") != distribution.at(i - 1, "method")) continue;
    EXPECT_GT(distribution.number(i, "share"), distribution.number(i - 1, "share"));
    EXPECT_LE(distribution.number(i, "error"), distribution.number(i - 1, "error"));
  }
}

TEST(CreepTables, RefusesAReferenceThatIsNotFiner) {
  EXPECT_THROW(parameters_of("creep_tables", read_creep_tables, {"reference.fine_cells=16"}),
               std::invalid_argument);
}

TEST(CreepTables, Verdicts) {
  // References on 10 and 11 cells have errors of some ten-thousandths themselves.
  std::vector<std::string> found = verdicts(few_states());
  ASSERT_EQ(found.size(), 12U);
  found.erase(found.begin());
  EXPECT_EQ(found, std::vector<std::string>(11, "ours"));
}

}  // namespace microslip::experiments::creep_tables_test
