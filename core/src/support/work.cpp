// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/work.hpp"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace microslip {

namespace {

constexpr std::chrono::milliseconds between_looks{100};

/// A whole number, which stays below 2^53 for months. Only the counted thread writes it.
thread_local std::atomic<double> counted = 0;

}  // namespace

void count_work(double operations) {
  const double before = counted.load(std::memory_order_relaxed);
  counted.store(before + std::round(operations), std::memory_order_relaxed);
}

WorkCount::WorkCount() : counted_(&counted), start_(counted.load(std::memory_order_relaxed)) {}

WorkWatch::WorkWatch(std::function<void(double)> action)
    : teller_([action = std::move(action), count = WorkCount()](const std::stop_token& stop) {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any end;
        while (!end.wait_for(lock, stop, between_looks, [] { return false; }) &&
               !stop.stop_requested()) {
          action(count.operations());
        }
        action(count.operations());
      }) {}

}  // namespace microslip
