// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/linalg/toeplitz_product.hpp"

namespace microslip {

/// Solves systems of some rows and columns of a Toeplitz matrix. The matrix from the first to the
/// last index is Toeplitz again and is inverted. If indices between these are missing, GMRES
/// solves, with that inverse as preconditioner. For differences of influence coefficients GMRES
/// takes 8 to 28 iterations to 1e-7, with 3 or with 800 intervals of indices:
/// tests/unit/toeplitz_test.cpp
class ToeplitzSubmatrix {
 public:
  /// \param tolerance  of the residual, relative to the right-hand side, where GMRES solves
  ToeplitzSubmatrix(const Toeplitz& matrix, double tolerance);

  /// \param indices  at least one, ascending. An inverse of the same size is kept.
  /// \throws NotConverged as ToeplitzInverse
  void choose(const std::vector<Eigen::Index>& indices);

  /// x = T_EE^-1 b, values at the chosen indices; not in place. Allocates nothing after the first
  /// solve with these indices, see Gmres.
  /// \return iterations of GMRES; 0 if no index is missing
  int solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Estimate of the condition number of the matrix from the first to the last index, in the
  /// 1-norm.
  double condition() const;

 private:
  Eigen::Index missing() const {
    return inverse_->size() - static_cast<Eigen::Index>(indices_.size());
  }
  void spread(const Eigen::VectorXd& x);
  void gather(const Eigen::VectorXd& all, Eigen::VectorXd& x) const;
  void precondition(const Eigen::VectorXd& x, Eigen::VectorXd& y);
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y);

  Toeplitz matrix_;
  double tolerance_;
  Gmres gmres_;
  std::vector<Eigen::Index> indices_;  ///< from the first one on, which is 0
  std::optional<ToeplitzProduct> product_;
  std::optional<ToeplitzInverse> inverse_;
  Eigen::VectorXd all_, response_;
};

}  // namespace microslip
