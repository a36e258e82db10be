// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace microslip {

/// Solves A x = b without assembling anything: GMRES (Saad and Schultz 1986), preconditioned from
/// the right, with the preconditioned directions kept (Saad 1993), so that an iteration costs one
/// preconditioning. The solver never restarts, and so suits preconditioners that need few
/// iterations.
class Gmres {
 public:
  /// y = matrix times x; y has the size of x.
  using Apply = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& y)>;

  /// Iterations and residual at the end of a solve.
  struct Outcome {
    int iterations;
    double residual;  ///< |b - A x| / |b| by the recursion, which does not see rounding errors
  };

  /// \param most  the largest number of iterations, >= 1
  /// Memory: 2 n numbers per iteration, which are kept for the next solve.
  explicit Gmres(int most);

  /// \param tolerance  the iteration ends when the residual is below it
  /// \param x          out: the solution; n
  /// The solve also ends after the largest number of iterations, and when another iteration gains
  /// nothing.
  Outcome solve(const Apply& matrix, const Apply& preconditioner, const Eigen::VectorXd& b,
                double tolerance, Eigen::VectorXd& x);

 private:
  void rotate_last_column(int k);

  int most_;
  std::vector<Eigen::VectorXd> directions_;  ///< orthonormal
  std::vector<Eigen::VectorXd> trials_;      ///< preconditioned directions
  Eigen::MatrixXd hessenberg_;               ///< rotated to triangular form as it grows
  Eigen::VectorXd cosines_, sines_;          ///< of the rotations of hessenberg_
  Eigen::VectorXd projected_;                ///< right-hand side, rotated by the same rotations
  Eigen::VectorXd product_;
};

}  // namespace microslip
