// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/linalg/real_fft.hpp"
#include "microslip/linalg/toeplitz.hpp"

namespace microslip {

/// The inverse of a Toeplitz matrix from its first and last column (Gohberg and Semencul 1972): a
/// product takes six transforms. The columns are found by GMRES with a CirculantInverse as
/// preconditioner; one column is enough if the matrix is symmetric. GMRES takes 10 to 22 iterations
/// for the influence coefficients of half-spaces and their differences over steps of any length,
/// whatever the size: tests/unit/toeplitz_test.cpp
class ToeplitzInverse {
 public:
  /// \throws NotConverged if the columns are not found, for example of a singular matrix
  explicit ToeplitzInverse(const Toeplitz& matrix);

  Eigen::Index size() const { return size_; }

  /// Iterations of GMRES for the column that took more iterations.
  int iterations() const { return iterations_; }

  /// x = T^-1 b; not in place. The residual is about 1e-16 times the condition number of T; one
  /// or two refinements reduce it to rounding.
  void apply(const Eigen::Ref<const Eigen::VectorXd>& b, Eigen::VectorXd& x) const;

  /// Estimate of the condition number of T in the 1-norm, see inverse_norm().
  double condition() const;

 private:
  /// Spectra of triangular Toeplitz matrices.
  Eigen::VectorXcd lower(const Eigen::VectorXd& first_column);
  Eigen::VectorXcd upper(const Eigen::VectorXd& first_row);

  Eigen::Index size_;
  double norm_;  ///< of T
  int iterations_ = 0;
  mutable RealFft fft_;
  // T^-1 = L U + L' U', where the factors include the scale of the transforms and the corner entry
  // of T^-1
  Eigen::VectorXcd first_lower_, first_upper_, second_lower_, second_upper_;
  mutable Eigen::VectorXcd spectrum_, sum_;
};

}  // namespace microslip
