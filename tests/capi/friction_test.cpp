// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that falls with slip through the C interface: the results of the C++ interface, second
// solutions, copies, speeds, and what is refused.
#include <gtest/gtest.h>

#include <string>

#include "handle.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip_friction.h"

namespace microslip::capi_friction_test {

constexpr microslip_friction law{.form = MICROSLIP_EXPONENTIAL_FALL,
                                 .kinetic_ratio = 0.4,
                                 .half_speed = 0.3,
                                 .speed = 1,
                                 .memory_length = 0.5,
                                 .memory_speed = 0.01,
                                 .branch = MICROSLIP_LEAST_SLIP};

SlipFriction friction() {
  return {.law = {FrictionLaw::Form::exponential, 0.4, 0.3},
          .speed = 1,
          .memory_length = 0.5,
          .memory_speed = 0.01};
}

TEST(FrictionInC, IsThatOfTheLibraryInLineContacts) {
  const Handle handle = created();
  ASSERT_EQ(microslip_set_friction(handle.get(), &law), MICROSLIP_OK)
      << microslip_message(handle.get());
  TransientProblem problem{.contact = {PlaneKernel({1, 0.28}, 200), HertzBound(1, 1)},
                           .grid = Grid({.half_width = 1, .elements = 41}),
                           .basis = constant_basis(),
                           .scheme = Remembered{}};
  problem.friction = friction();
  TransientRolling rolling(problem);
  ASSERT_EQ(microslip_set_creepage(handle.get(), 1.2), MICROSLIP_OK);
  for (int i = 0; i < 30; ++i) {
    if (i == 15) {
      rolling.set_speed(2);
      ASSERT_EQ(microslip_set_speed(handle.get(), 2), MICROSLIP_OK);
    }
    ASSERT_EQ(microslip_advance(handle.get(), 0.07), MICROSLIP_OK);
    rolling.step(0.07, PrescribedCreepage{1.2});
  }
  EXPECT_EQ(state_of(handle).force, rolling.state().force);
  EXPECT_EQ(microslip_has_second_solution(handle.get()), 0);
}

class FrictionOfEllipsesInC : public testing::Test {
 protected:
  void SetUp() override {
    const microslip_material material{1, 0.28};
    const microslip_ellipse_contact contact{1.3, 0.8, 1};
    const microslip_ellipse_grid grid{5, 8};
    ASSERT_EQ(microslip_ellipse_create(&material, &contact, &grid, &ellipse_, nullptr, 0),
              MICROSLIP_OK);
  }
  void TearDown() override { microslip_ellipse_destroy(ellipse_); }

  microslip_ellipse* ellipse_ = nullptr;
  microslip_ellipse_load load_{{0, 0, 0}, {1.1, -0.4, 0.2}};
};

// A state says what is wrong if it has another kind of friction than the contact that takes it.
TEST_F(FrictionOfEllipsesInC, HasStatesOfItsOwn) {
  const auto save = [](microslip_ellipse* ellipse) {
    std::string text(1 << 20, ' ');
    EXPECT_EQ(microslip_ellipse_save_to_memory(ellipse, text.data(), text.size(), nullptr),
              MICROSLIP_OK);
    return text;
  };
  const auto expect_refused = [&](const std::string& text, const std::string& error) {
    EXPECT_EQ(microslip_ellipse_restore_from_memory(ellipse_, text.c_str()), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(microslip_ellipse_message(ellipse_), "'friction_law': expected " + error);
  };
  const std::string of_coulomb = save(ellipse_);
  ASSERT_EQ(microslip_ellipse_set_friction(ellipse_, &law), MICROSLIP_OK);
  const std::string falling = save(ellipse_);
  expect_refused(of_coulomb, "a state of friction that falls with slip, as the contact has it");
  EXPECT_EQ(microslip_ellipse_restore_from_memory(ellipse_, falling.c_str()), MICROSLIP_OK);
  TearDown();
  SetUp();
  expect_refused(falling, "a state of Coulomb's friction without a law, as the contact has it");
  EXPECT_EQ(microslip_ellipse_restore_from_memory(ellipse_, of_coulomb.c_str()), MICROSLIP_OK);
}

TEST_F(FrictionOfEllipsesInC, IsThatOfTheLibrary) {
  ASSERT_EQ(microslip_ellipse_set_friction(ellipse_, &law), MICROSLIP_OK);
  SteadyPatch patch{.material = {1, 0.28},
                    .bound = EllipticBound(1.3, 0.8, 1),
                    .rows = 5,
                    .elements = 8,
                    .load = {{{false, 1.1}, {false, -0.4}, {false, 0.2}}}};
  patch.friction = friction();
  PatchRolling rolling(patch);
  microslip_ellipse_state state{};
  for (int i = 0; i < 12; ++i) {
    if (i == 6) {
      rolling.set_speed(2);
      patch.friction->speed = 2;
      ASSERT_EQ(microslip_ellipse_set_speed(ellipse_, 2), MICROSLIP_OK);
    }
    if (i % 3 == 1) {  // a trial is the step that follows
      ASSERT_EQ(microslip_ellipse_attempt(ellipse_, 0.2, &load_, &state, nullptr), MICROSLIP_OK);
    }
    ASSERT_EQ(microslip_ellipse_advance(ellipse_, 0.2, &load_, &state), MICROSLIP_OK);
    rolling.roll(0.2, patch.load);
  }
  EXPECT_EQ(state.resultants[0], rolling.resultants()[0]);
  EXPECT_EQ(state.resultants[2], rolling.resultants()[2]);
  EXPECT_EQ(microslip_ellipse_has_second_solution(ellipse_), 0);
  ASSERT_EQ(microslip_ellipse_solve_steady(ellipse_, &load_, &state, nullptr), MICROSLIP_OK);
  EXPECT_NEAR(state.resultants[0], solve_steady(patch).resultants[0], 1e-9);
  double jacobian[9];
  EXPECT_EQ(microslip_ellipse_solve_steady(ellipse_, &load_, &state, jacobian),
            MICROSLIP_BAD_INPUT);
  EXPECT_EQ(std::string(microslip_ellipse_message(ellipse_)),
            "friction_law: expected none where derivatives are asked for");
}

TEST_F(FrictionOfEllipsesInC, TellsOfASecondSolution) {
  microslip_friction at_once = law;
  at_once.memory_length = 0;
  at_once.speed = 3;
  ASSERT_EQ(microslip_ellipse_set_friction(ellipse_, &at_once), MICROSLIP_OK);
  microslip_ellipse* copy = nullptr;
  int seconds = 0;
  for (int i = 0; i < 60 && seconds == 0; ++i) {
    ASSERT_EQ(microslip_ellipse_advance(ellipse_, 0.05, &load_, nullptr), MICROSLIP_OK);
    seconds += microslip_ellipse_has_second_solution(ellipse_);
  }
  EXPECT_EQ(seconds, 1);
  ASSERT_EQ(microslip_ellipse_copy(ellipse_, &copy), MICROSLIP_OK);
  EXPECT_EQ(microslip_ellipse_has_second_solution(copy), 1);
  microslip_ellipse_destroy(copy);
}

TEST_F(FrictionOfEllipsesInC, RefusesBadNumbers) {
  const auto message = [&](const microslip_friction& friction) -> std::string {
    const Handle handle = created();
    EXPECT_EQ(microslip_set_friction(handle.get(), &friction), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(microslip_ellipse_set_friction(ellipse_, &friction), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(std::string(microslip_ellipse_message(ellipse_)), microslip_message(handle.get()));
    return microslip_message(handle.get());
  };
  microslip_friction bad = law;
  bad.form = 3;
  EXPECT_EQ(message(bad), "form = 3: expected a whole number 0 ... 2");
  bad = law;
  bad.branch = -1;
  EXPECT_EQ(message(bad), "branch = -1: expected a whole number 0 ... 1");
  bad = law;
  bad.kinetic_ratio = 1.5;
  EXPECT_EQ(message(bad).find("kinetic_ratio = 1.5: expected"), 0U);
  bad = law;
  bad.speed = 0;
  EXPECT_EQ(message(bad).find("speed = 0: expected"), 0U);
  const Handle handle = created();
  EXPECT_EQ(microslip_set_friction(handle.get(), nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_set_friction(nullptr, &law), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_set_speed(handle.get(), -1), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_ellipse_set_speed(ellipse_, 0), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_has_second_solution(nullptr), 0);
  EXPECT_EQ(microslip_ellipse_has_second_solution(nullptr), 0);
}

}  // namespace microslip::capi_friction_test
