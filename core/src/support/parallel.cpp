// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/parallel.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "microslip/support/require.hpp"

namespace microslip {

int available_cores() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return std::max(1, CPU_COUNT(&cores));
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void for_each_case(std::size_t count, int threads,
                   const std::function<void(std::size_t)>& do_case) {
  require(threads >= 1, "threads", threads, "a whole number >= 1");
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::size_t first = count;
  std::exception_ptr thrown;
  const auto do_cases = [&] {
    for (std::size_t i = next++; i < count && !failed; i = next++) {
      try {
        do_case(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failed = true;
        if (i < first) {
          first = i;
          thrown = std::current_exception();
        }
      }
    }
  };
  {
    std::vector<std::jthread> others;
    const std::size_t useful = std::min(static_cast<std::size_t>(threads), count);
    for (std::size_t k = 1; k < useful; ++k) others.emplace_back(do_cases);
    do_cases();
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace microslip
