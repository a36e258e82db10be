// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace microslip {

/// \file
/// Counted work: floating-point operations of this thread, by formulas in the sizes. The count is
/// the same on every machine on which iterations take as many rounds.
///
/// Counted: transforms (5/2 n log2 n of n real numbers), products (2 n^2), factors (2/3 n^3) and
/// solves (2 n^2) of dense matrices, orthogonalisation in GMRES, borders of factors, points of
/// quadratures and values of kernels (kernel_work each), series of Chebyshev polynomials, the
/// recursions of fractional powers, and the sweeps over all elements in a round of the active set.
/// Not counted: copies, comparisons, allocation, the making of plans for transforms, products of
/// vectors outside of these, and condition numbers.

/// Operations for a value of a kernel, a logarithm or some roots, and its use.
inline constexpr double kernel_work = 25;

/// \param operations  >= 0; rounded, so that sums are exact in any order
void count_work(double operations);

/// Counts operations of the thread that makes it, from then on. Another thread may read the count
/// as long as the counted thread lives.
class WorkCount {
 public:
  WorkCount();
  double operations() const { return counted_->load(std::memory_order_relaxed) - start_; }

 private:
  const std::atomic<double>* counted_;
  double start_;
};

/// Tells an action ten times a second how many operations the thread that made it has counted since
/// then. The action runs in a thread of its own, and for the last time before the destructor ends.
class WorkWatch {
 public:
  explicit WorkWatch(std::function<void(double operations)> action);

 private:
  std::jthread teller_;
};

}  // namespace microslip
