// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/work.hpp"

#include <cmath>
#include <utility>

namespace microslip {

namespace {

/// Whole, and below 2^53 for months.
thread_local double counted = 0;

thread_local WorkWatch* watching = nullptr;

}  // namespace

void count_work(double operations) {
  counted += std::round(operations);
  if (watching != nullptr) watching->look(counted);
}

WorkCount::WorkCount() : start_(counted) {}

double WorkCount::operations() const { return counted - start_; }

WorkWatch::WorkWatch(double every, std::function<void(double)> action)
    : start_(counted),
      every_(every),
      next_(counted + every),
      action_(std::move(action)),
      before_(std::exchange(watching, this)) {}

WorkWatch::~WorkWatch() { watching = before_; }

void WorkWatch::look(double now) {
  if (now < next_) return;
  next_ = now + every_;
  action_(now - start_);
}

}  // namespace microslip
