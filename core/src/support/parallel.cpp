// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/parallel.hpp"

#include <omp.h>

#include <atomic>
#include <exception>
#include <mutex>

#include "microslip/support/require.hpp"

namespace microslip {

int available_cores() { return omp_get_num_procs(); }

void for_each_case(std::size_t count, int threads,
                   const std::function<void(std::size_t)>& do_case) {
  require(threads >= 1, "threads", threads, "a whole number >= 1");
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::size_t first = count;
  std::exception_ptr thrown;
#pragma omp parallel for num_threads(threads) schedule(dynamic)
  for (std::size_t i = 0; i < count; ++i) {
    if (failed) continue;
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
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace microslip
