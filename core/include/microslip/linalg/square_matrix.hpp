// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include "microslip/linalg/toeplitz_product.hpp"

namespace microslip {

/// An n x n matrix, stored by all its entries or as a Toeplitz matrix, products with which are made
/// by FFT. One object serves one thread.
class SquareMatrix {
 public:
  SquareMatrix(Eigen::MatrixXd entries);  // NOLINT(google-explicit-constructor)
  SquareMatrix(const Toeplitz& matrix);   // NOLINT(google-explicit-constructor)

  Eigen::Index size() const;

  // One of them is null.
  const Toeplitz* toeplitz() const;
  const Eigen::MatrixXd* entries() const { return std::get_if<Eigen::MatrixXd>(&matrix_); }

  double operator()(Eigen::Index i, Eigen::Index j) const;

  /// Rows and columns of some indices.
  Eigen::MatrixXd block(const std::vector<Eigen::Index>& indices) const;

  /// Largest absolute value.
  double largest() const;

  /// y = M x; not in place.
  void apply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;

 private:
  struct ByFft {
    Toeplitz matrix;
    ToeplitzProduct product;
  };

  std::variant<Eigen::MatrixXd, ByFft> matrix_;
};

}  // namespace microslip
