// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// A square Toeplitz matrix T_ij = t_(i-j), stored as its first column and first row.
class Toeplitz {
 public:
  /// \param column  t_0, t_1, ..., t_(n-1)
  /// \param row     t_0, t_-1, ..., t_-(n-1); row[0] must equal column[0]
  /// \throws std::invalid_argument if column and row differ in size or in t_0
  Toeplitz(Eigen::VectorXd column, Eigen::VectorXd row);

  Eigen::Index size() const { return column_.size(); }
  bool is_symmetric() const { return column_ == row_; }

  /// The first n rows and columns, 1 <= n <= size().
  Toeplitz leading(Eigen::Index n) const;

  /// The matrix with a constant added to all entries.
  Toeplitz plus(double constant) const;

  Toeplitz times(double factor) const;

  double operator()(Eigen::Index i, Eigen::Index j) const {
    return i >= j ? column_[i - j] : row_[j - i];
  }

  /// The 1-norm, which is the largest sum of absolute values in a column. O(n)
  double norm() const;

  /// The full matrix: n^2 numbers.
  Eigen::MatrixXd dense() const;

 private:
  Eigen::VectorXd column_;
  Eigen::VectorXd row_;
};

}  // namespace microslip
