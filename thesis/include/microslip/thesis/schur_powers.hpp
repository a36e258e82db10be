// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>

namespace microslip {

/// Powers of a matrix by Eigen's Schur-Pade method. The method returns a matrix for any argument;
/// residual() tells whether the matrix is the power.
class SchurPowers {
 public:
  /// \param matrix  square, with one row at least; must outlive this
  explicit SchurPowers(const Eigen::MatrixXd& matrix);
  ~SchurPowers();

  /// Returns M^c for any c. O(n^3).
  Eigen::MatrixXd power(double c);

  /// Returns the largest entry of |M^c M^(1-c) - M| over the largest of |M|.
  double residual(const Eigen::MatrixXd& power, double c);

 private:
  class Method;  // Eigen's takes half a minute to compile: one source sees it
  const Eigen::MatrixXd& matrix_;
  std::unique_ptr<Method> method_;
};

/// Tells whether an eigenvalue is on the negative real axis, where the principal power is complex.
bool is_negative(const std::complex<double>& eigenvalue);

}  // namespace microslip
