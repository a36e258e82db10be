// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>

namespace microslip {

/// LU factors of a square n x n matrix, with partial pivoting: O(n^3) operations to make, O(n^2) for
/// each solve. They are Eigen's, compiled once: a source that calls Eigen's own takes some three
/// seconds longer to compile. A singular matrix gives values that are not finite.
class LuFactors {
 public:
  LuFactors() = default;
  explicit LuFactors(const Eigen::MatrixXd& matrix) { compute(matrix); }

  /// Takes another matrix; allocates if it is larger than the one before.
  /// \throws std::invalid_argument if it is not square
  void compute(const Eigen::MatrixXd& matrix);

  /// Solves A x = `right`, and allocates nothing if the solution has n entries. They may be one vector.
  void solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution) const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// Solves for each column of `right`.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;
  Eigen::MatrixXd inverse() const;

  /// An estimate of the reciprocal condition number in the 1-norm.
  double rcond() const;
  /// The ratio of the least pivot to the largest.
  double pivot_ratio() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// The x that makes |A x - `right`| least, by QR with column pivoting: that of A x = `right` if A is
/// square and regular, and finite if it is not. O(n^3).
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace microslip
