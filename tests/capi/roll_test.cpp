// SPDX-License-Identifier: GPL-3.0-or-later
// Many steps in one call are those made one by one, to the bit, all or none of them.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "c99.h"
#include "handle.hpp"

namespace microslip::roll_test {

/// Steps of any lengths under loads that change, with contacts that do if they are asked for.
struct Steps {
  std::vector<double> dq, load, half_width, bound;

  explicit Steps(std::size_t count, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (std::size_t k = 0; k < count; ++k) {
      dq.push_back(0.05 * std::exp(5 * uniform(random) - 4));
      load.push_back(2 * uniform(random) - 1);
      half_width.push_back(0.8 + 0.4 * uniform(random));
      bound.push_back(0.9 + 0.2 * uniform(random));
    }
  }
};

microslip_status make(const Handle& handle, const microslip_steps& steps,
                      std::vector<microslip_state>& states) {
  states.resize(steps.count);
  return microslip_roll(handle.get(), &steps, states.data());
}

TEST(CRoll, IsAsOneByOneToTheBit) {
  const Steps run(60);
  for (const bool by_force : {false, true}) {
    for (const bool changes : {false, true}) {
      for (const int scheme : {MICROSLIP_REMEMBERED, MICROSLIP_DIRECT}) {
        if (changes && scheme == MICROSLIP_DIRECT) continue;
        SCOPED_TRACE(testing::Message() << by_force << changes << scheme);
        const Parts parts{.grid = {41, scheme}};
        const Handle handle = created(parts), twin = created(parts);
        const microslip_steps steps{run.dq.size(),
                                    run.dq.data(),
                                    by_force ? nullptr : run.load.data(),
                                    by_force ? run.load.data() : nullptr,
                                    changes ? run.half_width.data() : nullptr,
                                    changes ? run.bound.data() : nullptr};
        std::vector<microslip_state> states;
        ASSERT_EQ(make(handle, steps, states), MICROSLIP_OK) << microslip_message(handle.get());
        for (std::size_t k = 0; k < run.dq.size(); ++k) {
          if (changes) microslip_set_contact(twin.get(), run.half_width[k], run.bound[k]);
          by_force ? microslip_set_force(twin.get(), run.load[k])
                   : microslip_set_creepage(twin.get(), run.load[k]);
          ASSERT_EQ(microslip_advance(twin.get(), run.dq[k]), MICROSLIP_OK);
          expect_same(numbers(states[k]), numbers(state_of(twin)));
        }
        expect_same(answers(handle), answers(twin));
        for (const Handle& h : {std::cref(handle), std::cref(twin)}) {  // load and contact remain
          ASSERT_EQ(microslip_advance(h.get(), 0.03), MICROSLIP_OK);
        }
        expect_same(answers(handle), answers(twin));
      }
    }
  }
}

TEST(CRoll, ThatFailsMakesNoStep) {
  const Steps run(20);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_refused = [&](const std::string& message, auto spoil) {
    Steps spoilt = run;
    spoil(spoilt);
    const Handle handle = created(), twin = created();
    for (const Handle& h : {std::cref(handle), std::cref(twin)}) roll(h, 12, 0.05);
    const microslip_steps steps{20,
                                spoilt.dq.data(),
                                nullptr,
                                spoilt.load.data(),
                                spoilt.half_width.data(),
                                spoilt.bound.data()};
    std::vector<microslip_state> states;
    EXPECT_EQ(make(handle, steps, states), MICROSLIP_BAD_INPUT);
    EXPECT_TRUE(std::string(microslip_message(handle.get())).starts_with(message))
        << microslip_message(handle.get());
    expect_same(answers(handle), answers(twin));
    for (const Handle& h : {std::cref(handle), std::cref(twin)}) {
      EXPECT_EQ(microslip_advance(h.get(), 0.07), MICROSLIP_OK);
    }
    expect_same(answers(handle), answers(twin));
  };
  expect_refused("steps[17]: dq = 1e-30: expected 0, or from 1e-15 to",
                 [](Steps& r) { r.dq[17] = 1e-30; });
  expect_refused("steps[0]: force = nan: expected an absolute value",
                 [&](Steps& r) { r.load[0] = nan; });
  expect_refused("steps[5]: half_width_factor = -2: expected a number >= 0",
                 [](Steps& r) { r.half_width[5] = -2; });
}

TEST(CRoll, RefusesStepsThatAreNone) {
  const Handle handle = created();
  const double one = 0.1;
  const auto expect_refused = [&](const std::string& message, const microslip_steps* steps) {
    EXPECT_EQ(microslip_roll(handle.get(), steps, nullptr), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(microslip_message(handle.get()), message);
  };
  const auto expect_of = [&](const std::string& message, const microslip_steps& steps) {
    expect_refused(message, &steps);
  };
  expect_refused("steps = null: expected a pointer", nullptr);
  expect_of("steps.dq = null: expected a pointer", {1, nullptr, &one, nullptr, nullptr, nullptr});
  expect_of("steps.force: expected null where there are creepages",
            {1, &one, &one, &one, nullptr, nullptr});
  expect_of("steps.bound_factor: expected an array where steps.half_width_factor is one, else null",
            {1, &one, &one, nullptr, &one, nullptr});
  expect_of("steps[0]: load: expected a creepage or a force to be set",
            {1, &one, nullptr, nullptr, nullptr, nullptr});
  EXPECT_EQ(microslip_roll(nullptr, nullptr, nullptr), MICROSLIP_BAD_INPUT);
  const microslip_steps none{0, nullptr, nullptr, nullptr, nullptr, nullptr};
  EXPECT_EQ(microslip_roll(handle.get(), &none, nullptr), MICROSLIP_OK);
  EXPECT_EQ(state_of(handle).distance, 0);
}

TEST(CRoll, WorksFromC99) {
  const Handle handle =
      created({.kernel = {MICROSLIP_STRIP, 4}, .grid = {20, MICROSLIP_REMEMBERED}});
  ASSERT_EQ(microslip_set_creepage(handle.get(), 0.5), MICROSLIP_OK);
  for (const double dq : {0.07, 0.01, 0.2})
    ASSERT_EQ(microslip_advance(handle.get(), dq), MICROSLIP_OK);
  EXPECT_EQ(force_after_steps_in_c99(), state_of(handle).force);
}

}  // namespace microslip::roll_test
