// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/unlike_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "study_tables.hpp"

namespace microslip::experiments::unlike_bodies_test {

const std::vector<Table>& tables() {
  static const std::vector<Table> all = tables_of(
      "unlike_bodies", read_unlike_bodies, unlike_bodies,
      {"material.shear_modulus=3", "material.poisson_ratio=0.3", "contact.half_width=2",
       "contact.peak_traction=0.1", "grid.elements=301", "free.points=13",
       "tractive.beta_over_mu=0.5 2.87667", "tractive.points=39", "error.sizes=100 200 400 800"});
  return all;
}

TEST(UnlikeBodiesStudy, FreeRollingCreepsMoreTheLessFrictionThereIs) {
  const Table& free = table_named(tables(), "free");
  for (std::size_t i = 1; i < free.rows(); ++i) {
    EXPECT_GT(free.number(i, "creepage"), free.number(i - 1, "creepage") - 1e-6);
    EXPECT_GE(free.number(i, "dissipation"), 0);
  }
  EXPECT_EQ(free.number(0, "zones"), 1);
  EXPECT_EQ(free.number(8, "zones"), 5);  // beta/mu = 5
  EXPECT_LT(free.number(12, "creepage"), 0.914771);
}

TEST(UnlikeBodiesStudy, ZonesFillTheContactAndSlipAgainstTheirTraction) {
  const Table& zones = table_named(tables(), "zones");
  for (std::size_t i = 0; i < zones.rows(); ++i) {
    EXPECT_LT(zones.number(i, "begin"), zones.number(i, "end"));
    const bool is_last = zones.number(i, "end") == 1;
    if (is_last || i + 1 == zones.rows()) continue;
    EXPECT_EQ(zones.number(i, "end"), zones.number(i + 1, "begin"));
    EXPECT_NE(zones.number(i, "zone"), zones.number(i + 1, "zone"));
  }
}

// A force that brakes, negative, raises the creepage, as it does for bodies that are alike.
TEST(UnlikeBodiesStudy, CreepageFallsWithTheForce) {
  const Table& tractive = table_named(tables(), "tractive");
  for (std::size_t i = 1; i < tractive.rows(); ++i) {
    if (tractive.number(i, "ratio") != tractive.number(i - 1, "ratio")) continue;
    EXPECT_LT(tractive.number(i, "creepage"), tractive.number(i - 1, "creepage"));
    EXPECT_LT(tractive.number(i, "alike"), tractive.number(i, "creepage"));
  }
}

TEST(UnlikeBodiesStudy, HasItsOrders) {
  const Table& orders = table_named(tables(), "orders");
  for (const double force : {0.0, 0.75, -0.75}) {
    EXPECT_NEAR(orders.latest({{"scheme", "standard"}, {"force_ratio", force}}, "order"), 1, 0.05);
    if (force == 0.75) continue;  // of which two zones are narrower than an element
    EXPECT_GT(orders.latest({{"scheme", "calibrated"}, {"force_ratio", force}}, "order"), 1.7);
  }
}

TEST(UnlikeBodiesStudy, ClaimsHold) {
  EXPECT_EQ(verdicts(tables()), std::vector<std::string>(6, "ours"));
}

}  // namespace microslip::experiments::unlike_bodies_test
