// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include "microslip/linalg/toeplitz_product.hpp"
#include "microslip/linalg/toeplitz_submatrix.hpp"

namespace microslip {

/// An n x n matrix. It is stored either by all its entries or as a Toeplitz matrix, whose products
/// are made by FFT. One object serves one thread.
class LinearOperator {
 public:
  LinearOperator(Eigen::MatrixXd entries);  // NOLINT(google-explicit-constructor)
  LinearOperator(const Toeplitz& matrix);   // NOLINT(google-explicit-constructor)

  Eigen::Index size() const;

  double operator()(Eigen::Index i, Eigen::Index j) const;

  /// The submatrix of the given rows and columns.
  Eigen::MatrixXd block(const std::vector<Eigen::Index>& indices) const;

  /// Solves systems of some rows and columns of the matrix plus a constant in every entry, which makes
  /// a symmetric matrix positive definite.
  struct BlockSolver {
    double constant;
    ToeplitzSubmatrix block;
  };

  /// A solver that is faster than LU factors of large blocks; none if all entries are stored.
  /// \param tolerance  of the residual, relative to the right-hand side, where GMRES solves
  std::optional<BlockSolver> block_solver(double tolerance) const;

  /// The largest absolute value of an entry.
  double largest() const;

  /// y = M x; not in place.
  void apply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;

 private:
  // The stored form; the other one is null.
  const Toeplitz* toeplitz() const;
  const Eigen::MatrixXd* entries() const { return std::get_if<Eigen::MatrixXd>(&matrix_); }

  struct ByFft {
    Toeplitz matrix;
    ToeplitzProduct product;
  };

  std::variant<Eigen::MatrixXd, ByFft> matrix_;
};

}  // namespace microslip
