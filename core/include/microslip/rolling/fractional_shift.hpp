// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/halfspace/shape_function.hpp"

namespace microslip {

/// Powers of C = A^-1 A*, A* taken one element upstream: thesis (8.4). C moves a traction one
/// element towards the trailing edge, where it leaves; the displacement that it caused is from then
/// on caused by `outflow` times what has left. So C is a companion matrix, ones next to the
/// diagonal and one full column, and (t + C) x = b takes O(n) operations.
///
/// The outflow is the linear predictor of the influence coefficients. As these are positive
/// definite, all eigenvalues of C lie inside the unit circle. With n odd, none is negative and
/// powers are real; with n even, one is.
class FractionalShift {
 public:
  /// \param spacing   dx, in (0, inf)  [mm]
  /// \param elements  n, odd
  /// \throws std::invalid_argument if n is even, or C has a negative eigenvalue (L0 < 3.8 a)
  /// \throws NotConverged if the influence coefficients are not positive definite, as in plane
  ///                      strain with a length L0 below that of the contact
  /// Cost: O(n^2), by Durbin's recursion; memory O(n).
  FractionalShift(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                  Eigen::Index elements);

  Eigen::Index size() const { return outflow_.size(); }

  /// First column of C, from the trailing edge  [1]
  const Eigen::VectorXd& outflow() const { return outflow_; }

  /// Tractions after a fractional step.
  struct Moved {
    Eigen::VectorXd traction;
    int solves;  ///< with a matrix t + C
  };

  /// C^c p, the principal power.
  /// \param step_ratio  c, >= 0
  /// Balakrishnan's integral for C^c - I by adaptive Gauss-Kronrod quadrature, so that small powers
  /// keep their digits. Cost: O(n) a solve, and 150 to 200 times log n solves.
  /// Accuracy: 1e-11 of the largest traction, tests/unit/fractional_shift_test.cpp
  /// \throws NotConverged if the quadrature fails
  Moved move(const Eigen::VectorXd& traction, double step_ratio) const;

 private:
  Eigen::VectorXd outflow_;
};

/// C itself: n^2 numbers.
Eigen::MatrixXd shift_matrix(const FractionalShift& shift);

}  // namespace microslip
