// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/MatrixFunctions>

namespace microslip::experiments {

/// Powers of a matrix by Eigen's Schur-Pade method. The method returns a matrix for any argument;
/// residual() tells whether the matrix is the power.
class SchurPowers {
 public:
  /// \param matrix  must outlive this
  explicit SchurPowers(const Eigen::MatrixXd& matrix);

  /// Returns M^c, c in (0, 1). O(n^3).
  Eigen::MatrixXd power(double c);

  /// Returns the largest entry of |M^c M^(1-c) - M| over the largest of |M|.
  double residual(const Eigen::MatrixXd& power, double c);

 private:
  const Eigen::MatrixXd& matrix_;
  Eigen::MatrixPower<Eigen::MatrixXd> powers_;
};

/// Tells whether an eigenvalue is on the negative real axis, where the principal power is complex.
bool is_negative(const std::complex<double>& eigenvalue);

}  // namespace microslip::experiments
