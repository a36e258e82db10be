// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/energy_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/support/convergence.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::energy_balance_test {

const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("energy_balance", read_energy_balance, energy_balance,
                {"grid.elements=60", "snapshots.positions=0.1 1 3", "error.sizes=100 200 400",
                 "motion.sizes=20 40 80", "motion.refinement=12", "control.step_ratios=4 2 1",
                 "control.tolerances=1e-4 1e-5"});
  return all;
}

double order_of(const std::string& scheme, const std::string& integrator,
                const std::string& quantity) {
  return table_named(tables(), "orders")
      .latest({{"scheme", scheme}, {"integrator", integrator}, {"quantity", quantity}}, "order");
}

TEST(EnergyBalanceStudy, EndOfStepBalanceIsFirstOrderForAllIntegratorsAndSchemes) {
  for (const char* scheme : {"direct", "remembered"}) {
    for (const char* integrator : {"verlet", "leapfrog", "midpoint"}) {
      EXPECT_NEAR(order_of(scheme, integrator, "energy"), 0.8, 0.3) << scheme << ' ' << integrator;
    }
  }
  EXPECT_NEAR(order_of("remembered", "verlet", "mean energy"), 2, 0.2);
}

TEST(EnergyBalanceStudy, MidpointBalancesToRoundingAtAnySize) {
  const Table& errors = table_named(tables(), "energy_error");
  for (std::size_t i = 0; i < errors.rows(); ++i) {
    const bool exact = std::get<std::string>(errors.at(i, "scheme")) == "remembered" &&
                       std::get<std::string>(errors.at(i, "integrator")) == "midpoint";
    if (exact) {
      EXPECT_LT(errors.number(i, "mean_error"), 1e-13);
    }
    EXPECT_GT(errors.number(i, "error"), 1e-4);
  }
}

// With the direct scheme the contact is of first order, which shows in shorter steps or on finer
// grids (tests/order/motion_order_test.cpp).
TEST(EnergyBalanceStudy, MotionIsSecondOrderForAllIntegrators) {
  for (const char* scheme : {"remembered", "remembered"}) {
    for (const char* integrator : {"verlet", "leapfrog", "midpoint"}) {
      for (const char* quantity : {"position", "velocity", "rotation"}) {
        EXPECT_NEAR(order_of(scheme, integrator, quantity), 2, 0.15)
            << scheme << ' ' << integrator << ' ' << quantity;
      }
    }
  }
  EXPECT_LT(order_of("direct", "verlet", "velocity"), 1.85);
}

// The error is that of the tolerance within a factor of three, and equal steps, of which it falls
// with the square of their number, are more.
TEST(EnergyBalanceStudy, StepsByATolerance) {
  const Table& control = table_named(tables(), "step_control");
  std::vector<double> equal_counts, equal_errors;
  std::size_t by_tolerance = 0;
  for (std::size_t i = 0; i < control.rows(); ++i) {
    const double error = control.number(i, "velocity_error");
    const double count = control.number(i, "count");
    if (std::get<std::string>(control.at(i, "steps")) == "equal") {
      equal_counts.push_back(count);
      equal_errors.push_back(error);
      continue;
    }
    ++by_tolerance;
    EXPECT_LT(error, 3 * control.number(i, "tolerance"));
    EXPECT_GT(error, control.number(i, "tolerance") / 3);
    const double equal = equal_counts.back() * std::sqrt(equal_errors.back() / error);
    EXPECT_GT(equal / count, 1.5);
  }
  EXPECT_NEAR(fitted_order(equal_counts, equal_errors), 2, 0.15);
  EXPECT_EQ(by_tolerance, 2U);
}

TEST(EnergyBalanceStudy, ShowsWhatWasAskedFor) {
  const Table& snapshots = table_named(tables(), "snapshots");
  EXPECT_GE(snapshots.rows(), 3U * 60);
  EXPECT_GE(table_named(tables(), "energy").rows(), 4U * 300);
}

TEST(EnergyBalanceStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()),
            (std::vector<std::string>{"reproduced", "reproduced", "reproduced", "ours", "ours",
                                      "ours", "ours", "ours", "ours"}));
}

}  // namespace microslip::experiments::energy_balance_test
