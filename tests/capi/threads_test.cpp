// SPDX-License-Identifier: GPL-3.0-or-later
// These tests hold the promises of microslip.h about threads. `make sanitize` runs them under the
// thread sanitizer, which sees races that give the right numbers by chance.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <thread>

#include "handle.hpp"

namespace microslip::threads_test {

void at_once(int threads, const std::function<void(int)>& work) {
  std::vector<std::thread> running;
  for (int i = 0; i < threads; ++i) running.emplace_back(work, i);
  for (std::thread& thread : running) thread.join();
}

constexpr int threads = 4;

/// Both schemes, small and large sizes: with dense matrices, and with transforms.
const Parts& parts_of(int i) {
  static const std::vector<Parts> all{
      {.grid = {41, MICROSLIP_REMEMBERED}},
      {.grid = {150, MICROSLIP_REMEMBERED}},
      {.grid = {151, MICROSLIP_DIRECT}},
      {.kernel = {MICROSLIP_STRIP, 3}, .grid = {60, MICROSLIP_DIRECT}}};
  return all[static_cast<std::size_t>(i) % all.size()];
}

TEST(CThreads, HandlesRollAndCopySideBySide) {
  const auto work = [](int i) {
    const Handle handle = created(parts_of(i));
    roll(handle, 12, 2.0 / parts_of(i).grid.elements);
    microslip_rolling* made = nullptr;
    EXPECT_EQ(microslip_copy(handle.get(), &made), MICROSLIP_OK);
    const Handle copy(made, microslip_destroy);
    roll(copy, 12, 2.0 / parts_of(i).grid.elements);
    return answers(copy);
  };
  std::vector<std::vector<double>> found(threads);
  at_once(threads, [&](int i) { found[static_cast<std::size_t>(i)] = work(i); });
  for (int i = 0; i < threads; ++i) expect_same(found[static_cast<std::size_t>(i)], work(i));
}

TEST(CThreads, CopiesOfOneHandleRollSideBySide) {
  for (int part = 0; part < 4; ++part) {
    const Handle handle = created(parts_of(part));
    const double spacing = 2.0 / parts_of(part).grid.elements;
    roll(handle, 5, spacing);
    std::vector<std::vector<double>> found(threads);
    at_once(threads, [&](int i) {
      microslip_rolling* made = nullptr;
      EXPECT_EQ(microslip_copy(handle.get(), &made), MICROSLIP_OK);
      const Handle copy(made, microslip_destroy);
      roll(copy, 8, spacing);
      found[static_cast<std::size_t>(i)] = answers(copy);
    });
    roll(handle, 8, spacing);
    for (const auto& one : found) expect_same(one, answers(handle));
  }
}

TEST(CThreads, OneHandleIsReadByAll) {
  for (int part = 0; part < 4; ++part) {
    const Handle handle = created(parts_of(part));
    roll(handle, 5, 2.0 / parts_of(part).grid.elements);
    const std::vector<double> expected = answers(handle);
    at_once(threads, [&](int i) {
      for (int k = 0; k < 5; ++k) {
        expect_same(answers(handle), expected);
        EXPECT_STREQ(microslip_method(handle.get()), i >= 0 && part < 2 ? "remembered" : "direct");
        EXPECT_STREQ(microslip_warning(handle.get()), "");
      }
    });
  }
}

TEST(CThreads, CallsWithOneHandleTakeTurns) {
  constexpr int steps = 25;
  const Handle handle = created(), twin = created();
  for (const Handle* h : {&handle, &twin}) {
    ASSERT_EQ(microslip_set_creepage(h->get(), 0.3), MICROSLIP_OK);
  }
  at_once(threads, [&](int i) {
    std::vector<double> values(41);
    const std::vector<double> dq(steps, 0.01);
    const microslip_steps all{dq.size(), dq.data(), nullptr, nullptr, nullptr, nullptr};
    microslip_state state{};
    if (i == 0) {
      EXPECT_EQ(microslip_roll(handle.get(), &all, nullptr), MICROSLIP_OK);
      return;
    }
    for (int k = 0; k < steps; ++k) {
      if (i == 1) {
        EXPECT_EQ(microslip_advance(handle.get(), 0.01), MICROSLIP_OK);
      }
      if (i == 2) {
        EXPECT_EQ(microslip_attempt(handle.get(), 0.03, &state), MICROSLIP_OK);
      }
      if (i == 3) {
        EXPECT_EQ(microslip_advance(handle.get(), 1e-30), MICROSLIP_BAD_INPUT);
        EXPECT_EQ(microslip_get_traction(handle.get(), values.data(), 41), MICROSLIP_OK);
        EXPECT_EQ(microslip_size(handle.get()), 41U);
        microslip_get_elastic_energy(handle.get(), values.data());
      }
    }
  });
  for (int k = 0; k < 2 * steps; ++k) ASSERT_EQ(microslip_advance(twin.get(), 0.01), MICROSLIP_OK);
  // Attempted steps leave rounding in the steps behind them.
  const std::vector<double> found = answers(handle), expected = answers(twin);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_EQ(found[0], expected[0]);
  EXPECT_NEAR(found[1], expected[1], 1e-11);
}

TEST(CThreads, StatesAreSavedAndSteadyRollingIsSolvedSideBySide) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("microslip_threads" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string one_file = folder / "one.state";
  const Handle handle = created();
  roll(handle, 6, 0.05);
  const Parts p;
  const double loads[] = {0.1, 0.5, 5};
  microslip_steady expected[3];
  ASSERT_EQ(microslip_solve_steady(&p.material, &p.contact, &p.kernel, 41, MICROSLIP_CREEPAGE,
                                   loads, 3, expected, nullptr, nullptr, 0),
            MICROSLIP_OK);
  at_once(threads, [&](int i) {
    EXPECT_EQ(microslip_save(handle.get(), one_file.c_str()), MICROSLIP_OK);
    const std::string own = folder / (std::to_string(i) + ".state");
    EXPECT_EQ(microslip_save(handle.get(), own.c_str()), MICROSLIP_OK);
    for (const std::string& file : {one_file, own}) {
      const Handle other = created();
      EXPECT_EQ(microslip_restore(other.get(), file.c_str()), MICROSLIP_OK)
          << microslip_message(other.get());
      expect_same(answers(other), answers(handle));
    }
    microslip_steady found[3];
    EXPECT_EQ(microslip_solve_steady(&p.material, &p.contact, &p.kernel, 41, MICROSLIP_CREEPAGE,
                                     loads, 3, found, nullptr, nullptr, 0),
              MICROSLIP_OK);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(found[k].force, expected[k].force);
  });
  std::filesystem::remove_all(folder);
}

}  // namespace microslip::threads_test
