// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/work.hpp"

#include <cmath>

namespace microslip {

namespace {

/// Whole, and below 2^53 for months.
thread_local double counted = 0;

}  // namespace

void count_work(double operations) { counted += std::round(operations); }

WorkCount::WorkCount() : start_(counted) {}

double WorkCount::operations() const { return counted - start_; }

}  // namespace microslip
