// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace microslip::parallel_test {

TEST(ForEachCase, DoesEachOnce) {
  EXPECT_GE(available_cores(), 1);
  for (const int threads : {1, 2, 7}) {
    for (const std::size_t count : {0U, 1U, 100U}) {
      std::vector<int> calls(count, 0);
      for_each_case(count, threads, [&](std::size_t i) { ++calls[i]; });
      EXPECT_EQ(calls, std::vector<int>(count, 1)) << threads;
    }
  }
}

TEST(ForEachCase, RunsAsManyAtOnceAsItMay) {
  using namespace std::chrono_literals;
  std::atomic<int> begun = 0;
  std::atomic<int> together = 0;
  for_each_case(3, 3, [&](std::size_t) {
    ++begun;
    for (int i = 0; i < 5000 && begun < 3; ++i) std::this_thread::sleep_for(1ms);
    if (begun == 3) ++together;
  });
  EXPECT_EQ(together, 3);
}

TEST(ForEachCase, PassesOnTheFirstExceptionAndBeginsNoOther) {
  for (const int threads : {1, 3}) {
    std::atomic<int> done = 0;
    try {
      for_each_case(1000, threads, [&](std::size_t i) {
        ++done;
        if (i >= 2) throw std::runtime_error(std::to_string(i));
      });
      ADD_FAILURE() << "expected an exception";
    } catch (const std::runtime_error& error) {
      EXPECT_GE(std::stoi(error.what()), 2);
      EXPECT_LT(std::stoi(error.what()), 2 + threads);
    }
    EXPECT_LE(done, 2 + threads);
  }
  EXPECT_THROW(for_each_case(1, 0, [](std::size_t) {}), std::invalid_argument);
}

}  // namespace microslip::parallel_test
