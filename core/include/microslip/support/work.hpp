// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace microslip {

/// \file
/// Counted work: floating-point operations that this thread has done so far, by formulas in the
/// sizes, so that they are the same on every machine as long as iterations take as many rounds.
///
/// Counted: transforms (5/2 n log2 n of n real numbers), products (2 n^2), factors (2/3 n^3) and
/// solves (2 n^2) of dense matrices, orthogonalisation in GMRES, borders of factors, points of
/// quadratures and values of kernels (kernel_work each), series of Chebyshev polynomials, the
/// recursions of fractional powers, and the sweeps over all elements in a round of the active set.
/// Not counted: copies, comparisons, allocation, the making of plans for transforms, products of
/// vectors outside of these, and condition numbers.

/// What a value of a kernel counts for, with what it is multiplied by: a logarithm or some roots.
inline constexpr double kernel_work = 25;

/// \param operations  >= 0; rounded, so that sums are exact in any order
void count_work(double operations);

/// Operations since it was made, on the same thread.
class WorkCount {
 public:
  WorkCount();
  double operations() const;

 private:
  double start_;
};

/// As long as it lives, an action is told of the operations on this thread since it was made, each
/// time that as many more have been done. Of several, the last that was made.
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
