// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

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

/// Counts operations of this thread since it was made.
class WorkCount {
 public:
  WorkCount();
  double operations() const;

 private:
  double start_;
};

/// Calls `action` with the number of operations of this thread since it was made, each time that
/// the thread has done `every` more. If there are several, only the last one that was made acts.
class WorkWatch {
 public:
  /// \param every  > 0
  WorkWatch(double every, std::function<void(double operations)> action);
  ~WorkWatch();
  WorkWatch(const WorkWatch&) = delete;
  WorkWatch& operator=(const WorkWatch&) = delete;

 private:
  friend void count_work(double operations);
  void look(double now);

  double start_;
  double every_;
  double next_;
  std::function<void(double)> action_;
  WorkWatch* before_;
};

}  // namespace microslip
