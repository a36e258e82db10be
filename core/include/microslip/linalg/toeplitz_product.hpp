// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/linalg/real_fft.hpp"
#include "microslip/linalg/toeplitz.hpp"

namespace microslip {

/// Products with a Toeplitz matrix by FFT, O(n log n). One object serves one thread.
class ToeplitzProduct {
 public:
  explicit ToeplitzProduct(const Toeplitz& matrix);

  Eigen::Index size() const { return size_; }

  /// y = T x; not in place.
  void apply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

 private:
  Eigen::Index size_;
  mutable RealFft fft_;
  Eigen::VectorXcd symbol_;  ///< spectrum of the circulant extension, divided by the size of the
                             ///< transforms
};

}  // namespace microslip
