// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of friction that falls with the speed of slip: closed forms, tables, the memory, and ranges.
#include "microslip/friction/friction_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace microslip::friction_law_test {

using Form = FrictionLaw::Form;
using Eigen::Vector2d, Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::infinity();
const FrictionLaw tabulated(Vector3d(0, 10, 40), Vector3d(1, 0.7, 0.4));

TEST(FrictionLaws, AreOneAtRestHalfwayAtTheHalfSpeedAndKineticInTheEnd) {
  for (const auto form : {Form::linear, Form::exponential, Form::rational}) {
    const FrictionLaw law(form, 0.6, 100);
    EXPECT_EQ(law(0), 1);
    EXPECT_NEAR(law(100), 0.8, 1e-15);
    EXPECT_NEAR(law(infinite), 0.6, 1e-15);
  }
}

// CONTACT's: linear to 0 at twice the half speed, 2^(-s/h), 1/(1 + s/h).
TEST(FrictionLaws, HaveTheShapesOfTheirNames) {
  EXPECT_NEAR(FrictionLaw(Form::linear, 0.6, 100)(150), 0.7, 1e-15);
  EXPECT_NEAR(FrictionLaw(Form::linear, 0.6, 100)(250), 0.6, 1e-15);
  EXPECT_NEAR(FrictionLaw(Form::exponential, 0.6, 100)(200), 0.7, 1e-15);
  EXPECT_NEAR(FrictionLaw(Form::rational, 0.6, 100)(300), 0.7, 1e-15);
}

TEST(FrictionLaws, OfTablesAreLinearBetweenRowsAndConstantBehind) {
  EXPECT_EQ(tabulated(0), 1);
  EXPECT_NEAR(tabulated(5), 0.85, 1e-15);
  EXPECT_NEAR(tabulated(10), 0.7, 1e-15);
  EXPECT_NEAR(tabulated(25), 0.55, 1e-15);
  EXPECT_NEAR(tabulated(41), 0.4, 1e-15);
  EXPECT_NEAR(tabulated(infinite), 0.4, 1e-15);
}

TEST(FrictionLaws, AreNowhereSteeperThanTheySay) {
  for (const FrictionLaw& law :
       {FrictionLaw(Form::linear, 0.3, 7), FrictionLaw(Form::exponential, 0.3, 7),
        FrictionLaw(Form::rational, 0.3, 7), tabulated}) {
    double steepest = 0;
    for (double speed = 0; speed < 60; speed += 0.01) {
      steepest = std::max(steepest, (law(speed) - law(speed + 0.01)) / 0.01);
    }
    EXPECT_LE(steepest, law.steepest() * (1 + 1e-9));
    EXPECT_GT(steepest, law.steepest() * 0.99);
  }
}

// With dr/dt = (law - r) v/d at a constant v, r goes from 1 to the law like exp(-v t/d).
TEST(MemoryOfFriction, FollowsTheLawOverItsLength) {
  const FrictionLaw law(Form::exponential, 0.5, 20);
  const SlipFriction friction{.law = law, .speed = 1000, .memory_length = 0.02};
  const double time = 1e-3, distance = 0.03, speed = distance / time;
  const double after = friction.ratio_after(1, distance, time);
  EXPECT_NEAR(after, law(speed) + (1 - law(speed)) * std::exp(-1.5), 1e-14);
  const double half = friction.ratio_after(1, distance / 2, time / 2);
  EXPECT_NEAR(friction.ratio_after(half, distance / 2, time / 2), after, 1e-14);
  EXPECT_EQ(friction.ratio_after(0.7, 0, time), 0.7);
  EXPECT_NEAR(friction.ratio_after(1, infinite, time), 0.5, 1e-15);
}

// A linear law over a speed that grows evenly with the way: from the differential equation by many
// small parts.
TEST(MemoryOfFriction, FollowsALawThatChangesOnTheWay) {
  const FrictionLaw law(Form::linear, 0.2, 100);
  const SlipFriction friction{.law = law, .speed = 1000, .memory_length = 0.02};
  const double from = 30, to = 90, time = 4e-4;
  constexpr int parts = 4000;
  double ratio = 0.95;
  for (int i = 0; i < parts; ++i) {
    const double place = (i + 0.5) / parts;  // of the way slipped
    const double way = (from + to) / 2 * time / parts;
    ratio = friction.ratio_after(ratio, way, way / std::lerp(from, to, place));
  }
  EXPECT_NEAR(friction.ratio_after(0.95, from, to, time), ratio, 1e-7);
  EXPECT_NEAR(friction.ratio_after(0.95, to, infinite, time), 0.2, 1e-15);
  EXPECT_EQ(friction.ratio_after(0.95, 0, 0, time), 0.95);
}

TEST(MemoryOfFriction, RecoversAtRestWithItsLeastSpeed) {
  const SlipFriction friction{
      .law = {Form::exponential, 0.5, 20}, .speed = 1000, .memory_length = 0.02, .memory_speed = 5};
  EXPECT_NEAR(friction.ratio_after(0.5, 0, 0.004), 1 - 0.5 * std::exp(-1), 1e-14);
}

TEST(FrictionLaws, RefuseWhatIsOutOfRange) {
  EXPECT_THROW(FrictionLaw(Form::linear, -0.1, 1), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Form::linear, 1.1, 1), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Form::linear, 0.5, 0), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Form::linear, 0.5, infinite), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Vector2d(1, 2), Vector2d(1, 0.5)), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Vector2d(0, 2), Vector2d(0.9, 0.5)), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Vector2d(0, 0), Vector2d(1, 0.5)), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Vector2d(0, 1), Vector2d(1, -0.5)), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Vector2d(0, 1), Vector2d(1, std::nan(""))), std::invalid_argument);
  EXPECT_THROW(FrictionLaw(Vector2d(0, 1), Vector3d(1, 0.5, 0.4)), std::invalid_argument);
  const FrictionLaw law(Form::linear, 0.5, 1);
  EXPECT_THROW(validate({.law = law, .speed = 0}), std::invalid_argument);
  EXPECT_THROW(validate({.law = law, .speed = 1, .memory_length = -1}), std::invalid_argument);
  EXPECT_THROW(validate({.law = law, .speed = 1, .memory_length = 1, .memory_speed = -1}),
               std::invalid_argument);
}

}  // namespace microslip::friction_law_test
