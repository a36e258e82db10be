// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>

namespace microslip {

/// Holds the LU factors of an n x n matrix A, with partial pivoting. They take O(n^3) operations,
/// and each solve takes O(n^2). The factors are Eigen's, compiled once: a source that calls Eigen
/// itself takes some three seconds longer to compile. A singular matrix gives values that are not
/// finite.
class LuFactors {
 public:
  LuFactors() = default;
  explicit LuFactors(const Eigen::MatrixXd& matrix) { compute(matrix); }

  /// Takes another matrix, and allocates unless it is as large as the one before.
  /// \throws std::invalid_argument if it is not square
  void compute(const Eigen::MatrixXd& matrix);

  /// Solves A x = `right`. The solution may be the same vector. Nothing is allocated if it has n
  /// entries.
  void solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// Solves for each column of `right`.
  Eigen::MatrixXd solve_columns(const Eigen::Ref<const Eigen::MatrixXd>& right) const;
  Eigen::MatrixXd inverse() const;

  /// Estimates the reciprocal of the condition number in the 1-norm.
  double rcond() const;
  /// Returns the ratio of the least pivot to the largest.
  double pivot_ratio() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// Finds the x that makes |A x - `right`| least, by QR with column pivoting, in O(n^3) operations.
/// If A is square and regular, x solves A x = `right`. If A is singular, x is finite. If A has a
/// value that is not finite, x has no finite one.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace microslip
