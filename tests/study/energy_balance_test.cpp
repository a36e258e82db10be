// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/energy_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "study_tables.hpp"

namespace microslip::experiments {
namespace {

const std::vector<Table>& tables() {
  static const std::vector<Table> all = energy_balance(
      {.scene = {.contact = {.kernel = PlaneKernel({1.44, 0.28}, 10),
                             .bound = HertzBound(1, 1),
                             .grid = Grid({.half_width = 1, .elements = 60}),
                             .basis = constant_basis(),
                             .scheme = MaterialFixed{}},
                 .cylinder = {.mass = 1, .inertia = 5000, .radius = 100, .slope_force = 0.3},
                 .integrator = Integrator::midpoint,
                 .step_ratio = 1,
                 .distance = 20},
       .snapshots = {0.1, 1, 3},
       .sizes = {50, 100, 200},
       .error_distance = 2,
       .motion_sizes = {25, 50, 100},
       .refinement = 6},
      [](std::size_t, std::size_t) {});
  return all;
}

double order_of(const std::string& frame, const std::string& integrator,
                const std::string& quantity) {
  return table_named(tables(), "orders")
      .latest({{"frame", frame}, {"integrator", integrator}, {"quantity", quantity}}, "order");
}

TEST(EnergyBalanceStudy, EndOfStepBalanceIsFirstOrderForAllIntegratorsAndFrames) {
  for (const char* frame : {"contact", "world"}) {
    for (const char* integrator : {"verlet", "leapfrog", "midpoint"}) {
      EXPECT_NEAR(order_of(frame, integrator, "energy"), 0.8, 0.3) << frame << ' ' << integrator;
    }
  }
  EXPECT_NEAR(order_of("world", "verlet", "mean energy"), 1.5, 0.6);
}

TEST(EnergyBalanceStudy, MidpointBalancesToRoundingAtAnySize) {
  const Table& errors = table_named(tables(), "energy_error");
  for (std::size_t i = 0; i < errors.rows(); ++i) {
    const bool exact = std::get<std::string>(errors.at(i, "frame")) == "world" &&
                       std::get<std::string>(errors.at(i, "integrator")) == "midpoint";
    if (exact) {
      EXPECT_LT(errors.number(i, "mean_error"), 1e-13);
    }
    EXPECT_GT(errors.number(i, "error"), 1e-4);
  }
}

// Bookkeeping that closes is no proof of accuracy: the motion is as wrong as with Verlet.
TEST(EnergyBalanceStudy, MotionIsFirstOrderForAllIntegrators) {
  for (const char* integrator : {"verlet", "leapfrog", "midpoint"}) {
    for (const char* quantity : {"position", "velocity"}) {
      EXPECT_NEAR(order_of("world", integrator, quantity), 1.25, 0.3) << integrator;
    }
  }
}

TEST(EnergyBalanceStudy, ShowsWhatWasAskedFor) {
  const Table& snapshots = table_named(tables(), "snapshots");
  EXPECT_GE(snapshots.rows(), 3U * 60);
  EXPECT_GE(table_named(tables(), "energy").rows(), 4U * 300);
}

TEST(EnergyBalanceStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()), (std::vector<std::string>{"reproduced", "reproduced", "reproduced",
                                                          "ours", "ours", "ours", "ours"}));
}

}  // namespace
}  // namespace microslip::experiments
