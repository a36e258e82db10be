// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>

namespace microslip::experiments {

/// Returns the least time of up to five repeats; no repeat begins after a second  [s]
template <class Work>
double least_time(Work work) {
  using Clock = std::chrono::steady_clock;
  double least = 0;
  double total = 0;
  for (int repeat = 0; repeat < 5 && total < 1; ++repeat) {
    const auto start = Clock::now();
    work();
    const double time = std::chrono::duration<double>(Clock::now() - start).count();
    least = repeat == 0 ? time : std::min(least, time);
    total += time;
  }
  return least;
}

}  // namespace microslip::experiments
