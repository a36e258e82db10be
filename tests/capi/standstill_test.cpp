// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing happens in steps of dq = 0: what follows is to the bit what it is without them.
#include <gtest/gtest.h>

#include <random>

#include "handle.hpp"

namespace microslip::standstill_test {

class Standstill : public testing::TestWithParam<int> {
 protected:
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  bool any(int below) { return std::uniform_int_distribution<int>(1, below)(random_) == 1; }

  void set(const std::vector<const Handle*>& handles, bool by_force, double load) {
    for (const Handle* handle : handles) {
      ASSERT_EQ(by_force ? microslip_set_force(handle->get(), load)
                         : microslip_set_creepage(handle->get(), load),
                MICROSLIP_OK);
    }
  }

 private:
  std::mt19937 random_{7};
};

INSTANTIATE_TEST_SUITE_P(Schemes, Standstill,
                         testing::Values(MICROSLIP_REMEMBERED, MICROSLIP_DIRECT),
                         [](const auto& scheme) {
                           return scheme.param == MICROSLIP_DIRECT ? "direct" : "remembered";
                         });

TEST_P(Standstill, ChangesNothingNowOrLater) {
  for (int run = 0; run < 30; ++run) {
    const Parts parts{.grid = {30 + run, GetParam()}};
    const bool changes = GetParam() == MICROSLIP_REMEMBERED && any(2);
    const Handle standing = created(parts), twin = created(parts);
    microslip_state state{};
    for (int k = 0; k < 25; ++k) {
      const double dq = 2.0 / parts.grid.elements * std::exp(uniform(-4, 1));
      if (any(6)) {
        for (const Handle* h : {&standing, &twin}) {
          ASSERT_EQ(microslip_shift_to_force(h->get(), 0.3, nullptr), MICROSLIP_OK);
        }
      }
      const bool by_force = any(2);
      if (k > 0) {  // the force of now, or any creepage, without a step
        set({&standing}, by_force, by_force ? state_of(standing).force : uniform(-2, 2));
        ASSERT_EQ(microslip_advance(standing.get(), 0), MICROSLIP_OK)
            << microslip_message(standing.get());
        ASSERT_EQ(microslip_attempt(standing.get(), -0.0, &state), MICROSLIP_OK);
        expect_same(numbers(state), numbers(state_of(twin)));
      }
      if (changes) {
        const double a = uniform(0.8, 1.2), b = uniform(0.9, 1.1);
        for (const Handle* h : {&standing, &twin}) microslip_set_contact(h->get(), a, b);
      }
      set({&standing, &twin}, by_force, uniform(-0.7, 0.7));
      if (any(3)) {  // a step that was attempted is still known
        for (const Handle* h : {&standing, &twin}) {
          ASSERT_EQ(microslip_attempt(h->get(), dq, &state), MICROSLIP_OK);
        }
      }
      for (const Handle* h : {&standing, &twin}) {
        ASSERT_EQ(microslip_advance(h->get(), dq), MICROSLIP_OK) << microslip_message(h->get());
      }
      expect_same(answers(standing), answers(twin));
    }
  }
}

TEST_P(Standstill, InArraysOfStepsHasTheStateOfBefore) {
  const Parts parts{.grid = {40, GetParam()}};
  std::vector<double> dq, load, moving_dq, moving_load;
  for (int k = 0; k < 400; ++k) {
    const bool stands = any(3);
    dq.push_back(stands ? 0 : 0.05 * std::exp(uniform(-4, 1)));
    load.push_back(uniform(-1, 1));
    if (stands) continue;
    moving_dq.push_back(dq.back());
    moving_load.push_back(load.back());
  }
  const Handle standing = created(parts), twin = created(parts);
  const microslip_state rest = state_of(twin);
  const auto roll = [](const Handle& handle, const std::vector<double>& lengths,
                       const std::vector<double>& creepages) {
    std::vector<microslip_state> states(lengths.size());
    const microslip_steps steps{lengths.size(), lengths.data(), creepages.data(),
                                nullptr,        nullptr,        nullptr};
    EXPECT_EQ(microslip_roll(handle.get(), &steps, states.data()), MICROSLIP_OK);
    return states;
  };
  const auto with = roll(standing, dq, load);
  const auto without = roll(twin, moving_dq, moving_load);
  expect_same(answers(standing), answers(twin));
  std::size_t moved = 0;
  for (std::size_t k = 0; k < dq.size(); ++k) {
    if (dq[k] > 0) ++moved;
    expect_same(numbers(with[k]), numbers(moved == 0 ? rest : without[moved - 1]));
  }
}

/// A line that names the change, and nothing that has changed.
void expect_refused(const Handle& handle, microslip_status status, const std::string& begin,
                    const std::string& end) {
  EXPECT_EQ(status, MICROSLIP_BAD_INPUT);
  const std::string message = microslip_message(handle.get());
  EXPECT_TRUE(message.starts_with(begin)) << message;
  EXPECT_TRUE(message.ends_with(end)) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST_P(Standstill, UnderAChangedLoadNamesTheShift) {
  const Handle handle = created({.grid = {40, GetParam()}}),
               twin = created({.grid = {40, GetParam()}});
  for (const Handle* h : {&handle, &twin}) roll(*h, 12, 0.05);
  const std::string shift = " as before in a step of length 0; a shift changes it without rolling";
  microslip_state state{};
  for (const double force : {0.5, state_of(handle).force + 1e-6, -state_of(handle).force}) {
    ASSERT_EQ(microslip_set_force(handle.get(), force), MICROSLIP_OK);
    expect_refused(handle, microslip_advance(handle.get(), 0), "force = ", shift);
    expect_refused(handle, microslip_attempt(handle.get(), 0, &state), "force = ", shift);
  }
  set({&handle, &twin}, false, 0.3);
  microslip_jacobian slopes{};
  expect_refused(handle, microslip_attempt_with_jacobian(handle.get(), 0, &state, &slopes),
                 "length = 0: expected a number > 0", "has no slopes");
  if (GetParam() == MICROSLIP_DIRECT) {
    expect_refused(handle, microslip_advance(handle.get(), -0.1), "dq = -0.1: expected 0, or from",
                   "; the scheme remembered alone rolls back");
  }
  if (GetParam() == MICROSLIP_REMEMBERED) {
    ASSERT_EQ(microslip_set_contact(handle.get(), 1.1, 1), MICROSLIP_OK);
    expect_refused(handle, microslip_advance(handle.get(), 0), "half_width_factor = 1.1", shift);
    ASSERT_EQ(microslip_set_contact(handle.get(), 1, 0.9), MICROSLIP_OK);
    expect_refused(handle, microslip_advance(handle.get(), 0), "bound_factor = 0.9", shift);
    // which a shift by 0 does
    ASSERT_EQ(microslip_shift_by_distance(handle.get(), 0, nullptr), MICROSLIP_OK);
    ASSERT_EQ(microslip_advance(handle.get(), 0), MICROSLIP_OK);
    return;
  }
  for (const Handle* h : {&handle, &twin})
    ASSERT_EQ(microslip_advance(h->get(), 0.03), MICROSLIP_OK);
  expect_same(answers(handle), answers(twin));
}

TEST(RollingBack, IsRollingForthInTheMirror) {
  const Parts parts{.grid = {40, MICROSLIP_REMEMBERED}};
  const Handle forth = created(parts), back = created(parts);
  for (int k = 0; k < 12; ++k) {
    const double dq = k < 7 ? 0.07 : -0.05, creepage = 0.3 - 0.04 * k;
    for (const auto& [handle, sign] : {std::pair{&forth, 1.0}, {&back, -1.0}}) {
      ASSERT_EQ(microslip_set_creepage(handle->get(), creepage), MICROSLIP_OK);
      ASSERT_EQ(microslip_advance(handle->get(), sign * dq), MICROSLIP_OK)
          << microslip_message(handle->get());
    }
    const microslip_state there = state_of(forth), mirrored = state_of(back);
    EXPECT_NEAR(mirrored.distance, -there.distance, 1e-12);
    EXPECT_NEAR(mirrored.force, -there.force, 1e-9);
    EXPECT_NEAR(mirrored.dissipation, there.dissipation, 1e-9);
    EXPECT_EQ(mirrored.creepage, there.creepage);
  }
}

TEST_P(Standstill, NeedsALoadAsAnyStepDoes) {
  const Handle handle = created({.grid = {40, GetParam()}});
  EXPECT_EQ(microslip_advance(handle.get(), 0), MICROSLIP_BAD_INPUT);
  ASSERT_EQ(microslip_set_force(handle.get(), 0), MICROSLIP_OK);
  EXPECT_EQ(microslip_advance(handle.get(), 0), MICROSLIP_OK);
  expect_same(answers(handle), answers(created({.grid = {40, GetParam()}})));
}

}  // namespace microslip::standstill_test
