// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/linalg/real_fft.hpp"
#include "microslip/linalg/toeplitz.hpp"

namespace microslip {

/// A preconditioner: the inverse of the circulant matrix nearest to a Toeplitz matrix. The entries
/// of that circulant are means over diagonals of the Toeplitz matrix (T. Chan 1988). The matrix is
/// extended with zeros to the next fast size.
class CirculantInverse {
 public:
  explicit CirculantInverse(const Toeplitz& matrix);

  /// x = C^-1 b: two transforms; not in place.
  void apply(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  Eigen::Index size_;
  mutable RealFft fft_;
  Eigen::VectorXcd symbol_;
};

}  // namespace microslip
