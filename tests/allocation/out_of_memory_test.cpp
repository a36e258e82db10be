// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface answers with an error where memory runs out, in each allocation of a call in
// turn.
#include "capi/handle.hpp"
#include "counted_malloc.hpp"

namespace microslip::out_of_memory_test {

Handle rolled(int elements) {
  Handle handle = created({.grid = {elements, MICROSLIP_REMEMBERED}});
  roll(handle, 3, 2.0 / elements);
  EXPECT_EQ(microslip_set_force(handle.get(), -1.2), MICROSLIP_OK);
  return handle;
}

/// Calls with a first, second, ... allocation that fails, until none does; each on a handle that is
/// like the others. FFTW would end the program in a plan: they are made before.
/// \param call    microslip_status(microslip_rolling*)
/// \param failed  what to expect of a handle where it ran out
/// \return how many failed
template <class Call, class Failed>
int fail_each(int elements, const Call& call, const Failed& failed) {
  EXPECT_EQ(call(rolled(elements).get()), MICROSLIP_OK);
  for (int number = 1;; ++number) {
    const Handle handle = rolled(elements);
    fail_allocation(allocations() + number);
    const microslip_status status = call(handle.get());
    fail_allocation(0);
    if (status == MICROSLIP_OK) return number - 1;
    EXPECT_EQ(status, MICROSLIP_OUT_OF_MEMORY);
    EXPECT_STREQ(microslip_message(handle.get()), "out of memory");
    failed(handle);
  }
}

class OutOfMemory : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Elements, OutOfMemory, testing::Values(60, 150));

TEST_P(OutOfMemory, AStepLosesTheHandle) {
  const auto step = [](microslip_rolling* rolling) { return microslip_advance(rolling, 0.013); };
  const int failures = fail_each(GetParam(), step, [&](const Handle& handle) {
    microslip_state state{};
    EXPECT_EQ(microslip_get_state(handle.get(), &state), MICROSLIP_OUT_OF_MEMORY);
    EXPECT_EQ(step(handle.get()), MICROSLIP_OUT_OF_MEMORY);
    EXPECT_EQ(microslip_size(handle.get()), 0u);
    EXPECT_STREQ(microslip_message(handle.get()),
                 "out of memory in an earlier step: expected no more than to be destroyed");
  });
  EXPECT_GT(failures, 5);
}

TEST_P(OutOfMemory, AShiftLosesTheHandle) {
  const auto shift = [](microslip_rolling* rolling) {
    return microslip_shift_to_force(rolling, 0.3, nullptr);
  };
  const int failures = fail_each(GetParam(), shift, [&](const Handle& handle) {
    EXPECT_EQ(shift(handle.get()), MICROSLIP_OUT_OF_MEMORY);
    EXPECT_EQ(microslip_size(handle.get()), 0u);
  });
  EXPECT_GT(failures, 5);
}

TEST_P(OutOfMemory, ACopyThatFailsChangesNothing) {
  const std::vector<double> before = answers(rolled(GetParam()));
  const auto copy = [](microslip_rolling* rolling) {
    microslip_rolling* made = nullptr;
    const microslip_status status = microslip_copy(rolling, &made);
    EXPECT_EQ(status == MICROSLIP_OK, made != nullptr);
    microslip_destroy(made);
    return status;
  };
  const auto unchanged = [&](const Handle& handle) { expect_same(answers(handle), before); };
  EXPECT_GT(fail_each(GetParam(), copy, unchanged), 20);
}

}  // namespace microslip::out_of_memory_test
