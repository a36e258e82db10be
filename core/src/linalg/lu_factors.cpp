// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/lu_factors.hpp"

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_permutation.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace microslip {

using Eigen::Index;
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
  const auto view = [](VectorXd& vector) {
    return gsl_vector_view_array(vector.data(), static_cast<std::size_t>(vector.size()));
  };
  const Index columns = matrix.cols(), rows = std::max(matrix.rows(), columns);
  if (columns == 0) return {};
  if (!matrix.allFinite()) {
    return VectorXd::Constant(columns, std::numeric_limits<double>::quiet_NaN());
  }
  // GSL takes rows in order, and as many of them as columns at least.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> factors(rows, columns);
  factors << matrix, MatrixXd::Zero(rows - matrix.rows(), columns);
  VectorXd b(rows), scales(columns), norms(columns), found = VectorXd::Zero(columns), left(rows);
  b << right, VectorXd::Zero(rows - matrix.rows());
  auto qr = gsl_matrix_view_array(factors.data(), static_cast<std::size_t>(rows),
                                  static_cast<std::size_t>(columns));
  auto tau = view(scales), work = view(norms), solution = view(found), residual = view(left);
  const auto right_view = view(b);
  const std::unique_ptr<gsl_permutation, decltype(&gsl_permutation_free)> order(
      gsl_permutation_calloc(static_cast<std::size_t>(columns)), gsl_permutation_free);
  if (!order) throw std::bad_alloc();
  int sign = 0;
  gsl_linalg_QRPT_decomp(&qr.matrix, &tau.vector, order.get(), &sign, &work.vector);
  const std::size_t rank = gsl_linalg_QRPT_rank(&qr.matrix, -1);  // to rounding
  if (rank == 0) return found;                                    // GSL would end the program
  gsl_linalg_QRPT_lssolve2(&qr.matrix, &tau.vector, order.get(), &right_view.vector, rank,
                           &solution.vector, &residual.vector);
  return found;
}

}  // namespace microslip
