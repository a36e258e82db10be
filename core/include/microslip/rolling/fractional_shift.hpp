// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"

namespace microslip {

/// Powers of M = A^-1 A*, where A* is taken one element upstream: thesis (8.4). M moves tractions
/// one element towards the trailing edge. The traction that leaves there is replaced by `outflow`
/// times itself, which causes the same displacement. So M is a companion matrix, with ones next to
/// the diagonal and one full column, and (t + M) x = b takes O(n) operations.
///
/// The outflow is the linear predictor of the influence coefficients. As the coefficients are
/// positive definite, all eigenvalues of M lie inside the unit circle. With n odd, no eigenvalue is
/// negative and powers are real; with n even, one eigenvalue is negative.
class FractionalShift {
 public:
  /// \param spacing   dx, in (0, inf)  [mm]
  /// \param elements  n, odd
  /// \throws std::invalid_argument if n is even, or M has a negative eigenvalue (L0 < 3.8 a)
  /// \throws NotConverged if the influence coefficients are not positive definite, as in plane
  ///                      strain with L0 below the length of the contact
  /// Cost: O(n^2), by Durbin's recursion; memory O(n).
  FractionalShift(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                  Eigen::Index elements);

  Eigen::Index size() const { return outflow_.size(); }

  /// First column of M, from the trailing edge  [1]
  const Eigen::VectorXd& outflow() const { return outflow_; }

  /// Tractions after a fractional step.
  struct Moved {
    Eigen::VectorXd traction;
    int solves;  ///< number of solves with a matrix t + C
  };

  /// M^c p, the principal power.
  /// \param step_ratio  c, >= 0
  /// Method: adaptive Gauss-Kronrod quadrature of Balakrishnan's integral for M^c - I, so that
  /// small powers keep their digits. Cost: O(n) per solve, with 150 to 200 times log n solves.
  /// Accuracy: 1e-11 of the largest traction, tests/unit/fractional_shift_test.cpp
  /// \throws NotConverged if the quadrature fails
  Moved move(const Eigen::VectorXd& traction, double step_ratio) const;

 private:
  Eigen::VectorXd outflow_;
};

/// The matrix M: n^2 numbers.
Eigen::MatrixXd shift_matrix(const FractionalShift& shift);

}  // namespace microslip
