// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <variant>
#include <vector>

#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/linalg/toeplitz_product.hpp"

namespace microslip {

/// Solves systems of some rows and columns of a Toeplitz matrix. Consecutive indices form an
/// interval, the block of which is Toeplitz again and is inverted. If there are several intervals,
/// GMRES solves, with the inverses of all as preconditioner.
class ToeplitzSubmatrix {
 public:
  /// \param tolerance  of the residual where there are several intervals
  ToeplitzSubmatrix(const Toeplitz& matrix, double tolerance);

  /// \param indices  at least one, ascending. Inverses of intervals of a known length are kept.
  /// \throws NotConverged as ToeplitzInverse
  void choose(const std::vector<Eigen::Index>& indices);

  /// x = T_EE^-1 b, values at the chosen indices; not in place. Allocates nothing after the first
  /// solve with these indices, see Gmres.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

  /// Estimate of the condition number in the 1-norm: the worst of the intervals'.
  double condition() const;

 private:
  using SmallInverse = Eigen::PartialPivLU<Eigen::MatrixXd>;

  struct Interval {
    Eigen::Index first;  ///< among the indices
    Eigen::Index size;
    std::variant<SmallInverse, ToeplitzInverse> inverse;
    Eigen::VectorXd solution;
  };

  Interval inverted(Eigen::Index first, Eigen::Index size) const;
  void invert_intervals(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y);

  Toeplitz matrix_;
  ToeplitzProduct product_;
  double tolerance_;
  Gmres gmres_;
  std::vector<Eigen::Index> indices_;
  std::vector<Interval> intervals_;
  Eigen::VectorXd all_, response_;
};

}  // namespace microslip
