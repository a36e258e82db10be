// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace microslip {

/// \file
/// Counted work: floating-point operations of this thread, from formulas in the sizes. The count is
/// the same on all machines on which iterations take the same number of rounds.
///
/// Counted: transforms (5/2 n log2 n of n real numbers), products (2 n^2), factors (2/3 n^3) and
/// solves (2 n^2) of dense matrices, orthogonalisation in GMRES, borders of factors, points of
/// quadratures and values of kernels (kernel_work each), series of Chebyshev polynomials, the
/// recursions of fractional powers, and the sweeps over all elements in a round of the active set.
/// Not counted: copies, comparisons, allocation, plans for transforms, other products of vectors,
/// and condition numbers.

/// Operations to compute a value of a kernel, which takes a logarithm or some roots, and to use it.
inline constexpr double kernel_work = 25;

/// \param operations  >= 0; rounded to a whole number, so that sums are exact in any order
void count_work(double operations);

/// Counts the operations of the thread that constructs it, from the construction on. Another thread
/// may read the count as long as the counted thread lives.
class WorkCount {
 public:
  WorkCount();
  double operations() const { return counted_->load(std::memory_order_relaxed) - start_; }

 private:
  const std::atomic<double>* counted_;
  double start_;
};

/// Calls an action ten times a second with the number of operations that the constructing thread
/// has counted since the construction. The action runs in a thread of its own, and for the last
/// time before the destructor ends.
class WorkWatch {
 public:
  explicit WorkWatch(std::function<void(double operations)> action);

 private:
  std::jthread teller_;
};

}  // namespace microslip
