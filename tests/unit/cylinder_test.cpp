// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/dynamics/cylinder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hertz_cylinder.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::cylinder_test {

constexpr Cylinder cylinder{.mass = 1, .inertia = 5000, .radius = 100, .slope_force = 0.3};

RollingCylinder rolling(Integrator integrator, AdvectionScheme scheme = Remembered{},
                        double step_ratio = 1, const Cylinder& body = cylinder, Eigen::Index n = 40,
                        std::optional<double> tolerance = {}) {
  return hertz_cylinder({1.44, 0.28}, n, scheme, body, integrator, step_ratio, tolerance);
}

void roll_to(RollingCylinder& body, double distance) {
  while (body.state().position < distance) body.step();
}

class EveryIntegrator : public testing::TestWithParam<Integrator> {};

std::string name_of(const testing::TestParamInfo<Integrator>& integrator) {
  constexpr const char* names[] = {"verlet", "leapfrog", "midpoint"};
  return names[static_cast<int>(integrator.param)];
}

INSTANTIATE_TEST_SUITE_P(Integrators, EveryIntegrator,
                         testing::Values(Integrator::verlet, Integrator::leapfrog,
                                         Integrator::midpoint),
                         name_of);

// In the end it rolls with a constant creepage w, so that (1 - w) dv/dt = R domega/dt = -2 F/m for
// a solid cylinder.
TEST_P(EveryIntegrator, SettlesToRolling) {
  RollingCylinder body = rolling(GetParam());
  roll_to(body, 60);
  const double v = body.state().velocity;
  const double time = body.state().time;
  EXPECT_NEAR(body.state().force, -0.1, 0.01);
  EXPECT_NEAR(body.state().angular_velocity * cylinder.radius / v, 1, 0.05);
  roll_to(body, 80);
  const double rolled = 0.3 / (1 + (1 - body.state().creepage) / 2);
  EXPECT_NEAR((body.state().velocity - v) / (body.state().time - time), rolled, 5e-4);
}

// Forces and their moments, summed over the steps.
TEST_P(EveryIntegrator, ChangesOfMomentumAreThoseOfTheForces) {
  RollingCylinder body = rolling(GetParam());
  for (int k = 0; k < 100; ++k) body.step();
  const double linear = cylinder.mass * body.state().velocity;
  const double angular = cylinder.inertia * body.state().angular_velocity / cylinder.radius;
  EXPECT_NEAR(linear + angular, cylinder.slope_force * body.state().time, 1e-12);
}

TEST_P(EveryIntegrator, StartsFromRestInStepsOfAboutAnElement) {
  for (const double step_ratio : {1.0, 0.3}) {
    RollingCylinder body = rolling(GetParam(), Remembered{}, step_ratio);
    double before = 0;
    for (int k = 0; k < 30; ++k) {
      body.step();
      const double length = body.state().position - before;
      EXPECT_GT(length, 0);
      EXPECT_LT(length, 1.5 * step_ratio * 0.05);
      before = body.state().position;
    }
  }
}

TEST_P(EveryIntegrator, StartsFromRestInNoLongerStepThanAskedFor) {
  Cylinder steep = cylinder;
  steep.slope_force = 300;
  RollingCylinder body = rolling(GetParam(), Remembered{}, 60, steep);
  body.step();
  EXPECT_LT(body.state().position, 60 * 0.05);
}

TEST_P(EveryIntegrator, StartsFromFreeRolling) {
  Cylinder moving = cylinder;
  moving.velocity = 3;
  RollingCylinder body = rolling(GetParam(), Remembered{}, 1, moving);
  EXPECT_EQ(body.state().velocity, 3);
  EXPECT_EQ(body.state().angular_velocity, 0.03);
  body.step();
  EXPECT_NEAR(body.state().position, 0.05, 1e-3);
  roll_to(body, 5);
  EXPECT_NEAR(body.state().angular_velocity * moving.radius / body.state().velocity, 1, 0.05);
  const double linear = moving.mass * (body.state().velocity - 3);
  const double angular = moving.inertia * (body.state().angular_velocity - 0.03) / moving.radius;
  EXPECT_NEAR(linear + angular, moving.slope_force * body.state().time, 1e-12);
}

// With slopes so small that steps are parts of the period, and so large that they are elements.
TEST(RollingCylinder, KnowsHowManyStepsItTakes) {
  for (const double velocity : {0.0, 0.1, 2.0}) {
    for (const double slope : {1e-4, 1e-3, 0.3}) {
      Cylinder body = cylinder;
      body.slope_force = slope;
      body.velocity = velocity;
      for (const double distance : {0.02, 0.5, 5.0}) {
        RollingCylinder rolled = rolling(Integrator::verlet, Remembered{}, 1, body);
        const double steps = rolled.steps_from_start(distance);
        int taken = 0;
        for (; rolled.state().position < distance; ++taken) rolled.step();
        EXPECT_NEAR(taken, steps, 0.2 * taken + 2) << slope << ' ' << distance << ' ' << velocity;
      }
    }
  }
}

TEST(RollingCylinder, RefusesASlopeThatNextToNeverMovesIt) {
  Cylinder body = cylinder;
  body.slope_force = 1e-15;
  const auto made = [&] { rolling(Integrator::midpoint, Remembered{}, 1, body); };
  EXPECT_THROW(made(), std::invalid_argument);
}

// A solid cylinder that rolls needs a third of the slope's force at the contact, and twice that
// where it swings. On a gentle slope the first element takes so long that time steps follow the
// swing; on 40 elements it grows by a percent in the first five.
TEST_P(EveryIntegrator, FollowsTheSwingOfTheContactOnAGentleSlope) {
  for (const double slope_force : {1e-2, 1e-4, 1e-6}) {
    Cylinder gentle = cylinder;
    gentle.slope_force = slope_force;
    RollingCylinder body = rolling(GetParam(), Remembered{}, 1, gentle, 80);
    for (int k = 0; k < 200; ++k) {
      body.step();
      EXPECT_GT(body.state().force, -0.68 * slope_force);
      EXPECT_LT(body.state().force, 0.01 * slope_force);
    }
  }
}

TEST(RollingCylinder, MidpointBalancesEnergyToRounding) {
  for (const double velocity : {0.0, 1.0}) {
    Cylinder started = cylinder;
    started.velocity = velocity;
    for (const double step_ratio : {1.0, 0.37, 2.5}) {
      RollingCylinder body = rolling(Integrator::midpoint, Remembered{}, step_ratio, started);
      roll_to(body, 10);
      const EnergyLedger ledger = body.ledger();
      EXPECT_GT(ledger.dissipated, 1e-3);
      EXPECT_LT(std::abs(ledger.total()), 1e-13 * -ledger.potential) << step_ratio;
      EXPECT_GT(std::abs(ledger.end_total()), 1e-4 * -ledger.potential);
    }
  }
}

TEST(RollingCylinder, KeepsTheBalanceOfEnergyInStepsByATolerance) {
  for (const double tolerance : {1e-3, 1e-5}) {
    RollingCylinder body = rolling(Integrator::midpoint, Remembered{}, 4, cylinder, 40, tolerance);
    roll_to(body, 5);
    EXPECT_LT(std::abs(body.ledger().total()), 1e-13 * -body.ledger().potential);
  }
}

// Near rest the force bends most; later on, steps are as long as without a tolerance.
TEST(RollingCylinder, TakesShorterStepsWhereTheForceBends) {
  RollingCylinder body = rolling(Integrator::midpoint, Remembered{}, 4, cylinder, 40, 1e-5);
  RollingCylinder without = rolling(Integrator::midpoint, Remembered{}, 4);
  body.step();
  without.step();
  EXPECT_LT(body.state().time, 0.25 * without.state().time);
  roll_to(body, 60);
  roll_to(without, 60);
  const double before = body.state().position, before_without = without.state().position;
  body.step();
  without.step();
  EXPECT_NEAR(body.state().position - before, without.state().position - before_without, 0.02);
}

TEST(RollingCylinder, RefusesToleranceThatTheGridCannotMeet) {
  RollingCylinder body = rolling(Integrator::midpoint, Direct{}, 0.3, cylinder, 20, 1e-9);
  try {
    roll_to(body, 5);
    FAIL();
  } catch (const NotConverged& error) {
    EXPECT_NE(std::string(error.what()).find("motion tolerance = 1e-09"), std::string::npos)
        << error.what();
  }
}

TEST(RollingCylinder, RejectsTolerancesOutsideTheRange) {
  const auto made = [](Integrator by, double tolerance) {
    rolling(by, Remembered{}, 1, cylinder, 40, tolerance);
  };
  EXPECT_NO_THROW(made(Integrator::midpoint, 1));
  EXPECT_THROW(made(Integrator::midpoint, 0), std::invalid_argument);
  EXPECT_THROW(made(Integrator::midpoint, 1.01), std::invalid_argument);
  EXPECT_THROW(made(Integrator::verlet, 1e-3), std::invalid_argument);
}

// The two schemes of thesis chapter 9 are one: half a step more of velocity is what the other adds
// at the start of its next step.
TEST(RollingCylinder, VerletAndLeapfrogAreTheSame) {
  RollingCylinder verlet = rolling(Integrator::verlet);
  RollingCylinder leapfrog = rolling(Integrator::leapfrog);
  for (int k = 0; k < 300; ++k) {
    verlet.step();
    leapfrog.step();
    EXPECT_NEAR(verlet.state().position, leapfrog.state().position, 1e-11);
    EXPECT_NEAR(verlet.state().velocity, leapfrog.state().velocity, 1e-11);
  }
}

TEST(RollingCylinder, SlidesWhereTheSlopeIsTooSteep) {
  Cylinder steep = cylinder;
  steep.slope_force = 10;
  RollingCylinder body = rolling(Integrator::verlet, Remembered{}, 1, steep);
  roll_to(body, 5);
  EXPECT_LT(body.state().force, -0.95 * HertzBound(1, 1).total());
  EXPECT_GT(body.state().creepage, 0.2);
}

TEST(RollingCylinder, SaysWhenItStalls) {
  Cylinder stuck = cylinder;
  stuck.slope_force = 0.003;
  stuck.inertia = 1e6;
  RollingCylinder body = rolling(Integrator::verlet, Direct{}, 1, stuck);
  try {
    roll_to(body, 5);
    FAIL() << "expected it to stall, but v = " << body.state().velocity;
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("stalls or rolls backwards"), std::string::npos);
  }
}

TEST(RollingCylinder, RejectsConstantsOutsideTheRange) {
  Cylinder body = cylinder;
  body.mass = 0;
  EXPECT_THROW(rolling(Integrator::verlet, Direct{}, 1, body), std::invalid_argument);
  body = cylinder;
  body.velocity = -1;
  EXPECT_THROW(rolling(Integrator::verlet, Direct{}, 1, body), std::invalid_argument);
  body = cylinder;
  body.slope_force = -1;
  EXPECT_THROW(rolling(Integrator::verlet, Direct{}, 1, body), std::invalid_argument);
  EXPECT_THROW(rolling(Integrator::verlet, Direct{}, 0), std::invalid_argument);
}

}  // namespace microslip::cylinder_test
