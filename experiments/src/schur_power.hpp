// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/MatrixFunctions>

namespace microslip::experiments {

/// Powers of a matrix by Eigen's Schur-Pade method, with what tells whether they can be trusted:
/// that method returns a matrix for any argument.
class SchurPowers {
 public:
  /// \param matrix  must outlive this
  explicit SchurPowers(const Eigen::MatrixXd& matrix);

  /// M^c, c in (0, 1). O(n^3).
  Eigen::MatrixXd power(double c);

  /// Largest entry of |M^c M^(1-c) - M|, over that of |M|.
  double residual(const Eigen::MatrixXd& power, double c);

 private:
  const Eigen::MatrixXd& matrix_;
  Eigen::MatrixPower<Eigen::MatrixXd> powers_;
};

/// Where the principal power would be complex: on the negative real axis.
bool is_negative(const std::complex<double>& eigenvalue);

}  // namespace microslip::experiments
