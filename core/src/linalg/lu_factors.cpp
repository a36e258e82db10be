// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/lu_factors.hpp"

#include <Eigen/QR>
#include <stdexcept>

namespace microslip {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void LuFactors::compute(const MatrixXd& matrix) {
  if (matrix.rows() != matrix.cols()) {
    throw std::invalid_argument("LuFactors: the matrix must be square");
  }
  factors_.compute(matrix);
}

void LuFactors::solve(const VectorXd& right, VectorXd& solution) const {
  solution = factors_.solve(right);
}

VectorXd LuFactors::solve(const VectorXd& right) const { return factors_.solve(right); }

MatrixXd LuFactors::solve_columns(const Eigen::Ref<const MatrixXd>& right) const {
  return factors_.solve(right);
}

MatrixXd LuFactors::inverse() const { return factors_.inverse(); }

double LuFactors::rcond() const { return factors_.rcond(); }

double LuFactors::pivot_ratio() const {
  const VectorXd pivots = factors_.matrixLU().diagonal().cwiseAbs();
  return pivots.minCoeff() / pivots.maxCoeff();
}

VectorXd least_squares(const MatrixXd& matrix, const VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

}  // namespace microslip
