// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/falling_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::falling_friction_test {

std::vector<Table> found_with(const std::vector<std::string>& settings) {
  return tables_of("falling_friction", read_falling_friction, falling_friction, settings);
}

TEST(FallingFrictionStudy, Verdicts) {
  const std::vector<std::string> all =
      verdicts(found_with({"steady.elements=81 641", "steady.memories=0 0.002", "curve.points=2",
                           "run.memories=0 0.002", "steps.lengths=1 0.5 0.3 0.25 0.1 0.05 0.025"}));
  EXPECT_EQ(all, std::vector<std::string>(all.size(), "ours"));
}

// CONTACT (2025) prints these for its example veldep_fric: Fx/(mu Fn), and the elements in adhesion.
TEST(FallingFrictionStudy, HasTheElementsInAdhesionOfContact) {
  const std::vector<Table> found =
      found_with({"steady.elements=41", "steady.memories=0", "curve.points=2", "run.memories=0",
                  "run.distance=5", "run.step_ratios=1", "steps.lengths=0.5 0.1"});
  const Table& contact = table_named(found, "contact");
  const std::vector<double> adhesion = {45, 77, 34}, force = {0.5941, 0.5977, 0.5702};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(contact.number(i, "adhesion_elements"), adhesion[i]);
    EXPECT_NEAR(contact.number(i, "force_ratio"), force[i], 1.5e-3);
  }
}

// Without a fall of friction there is nothing to be unstable: all limits are 0.
TEST(FallingFrictionStudy, HasNoLimitsWhereFrictionStays) {
  const std::vector<Table> found = found_with(
      {"contact.kinetic_ratio=1", "steady.elements=41", "steady.memories=0", "curve.points=2",
       "run.memories=0 0.001", "run.distance=5", "run.step_ratios=1", "steps.lengths=0.5 0.1"});
  const Table& limits = table_named(found, "limits");
  for (std::size_t i = 0; i < limits.rows(); ++i) EXPECT_LT(limits.number(i, "limit"), 1e-9);
  const Table& steps = table_named(found, "steps");
  for (std::size_t i = 0; i < steps.rows(); ++i) {
    EXPECT_EQ(steps.number(i, "second_solution"), 0);
  }
}

TEST(FallingFrictionStudy, RefusesACreepageThatDoesNotDrive) {
  EXPECT_THROW(parameters_of("falling_friction", read_falling_friction, {"load.creepage=0.001"}),
               std::invalid_argument);
  EXPECT_THROW(parameters_of("falling_friction", read_falling_friction, {"run.shown=100"}),
               std::invalid_argument);
}

}  // namespace microslip::experiments::falling_friction_test
