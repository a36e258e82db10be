// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/linear_operator.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LinearOperator::LinearOperator(MatrixXd entries) : matrix_(std::move(entries)) {}

LinearOperator::LinearOperator(const Toeplitz& matrix)
    : matrix_(ByFft{matrix, ToeplitzProduct(matrix)}) {}

Index LinearOperator::size() const {
  const auto* toeplitz_matrix = toeplitz();
  return toeplitz_matrix ? toeplitz_matrix->size() : entries()->rows();
}

const Toeplitz* LinearOperator::toeplitz() const {
  const auto* by_fft = std::get_if<ByFft>(&matrix_);
  return by_fft ? &by_fft->matrix : nullptr;
}

double LinearOperator::operator()(Index i, Index j) const {
  const auto* toeplitz_matrix = toeplitz();
  return toeplitz_matrix ? (*toeplitz_matrix)(i, j) : (*entries())(i, j);
}

MatrixXd LinearOperator::block(const std::vector<Index>& indices) const {
  if (entries() != nullptr) return (*entries())(indices, indices);
  const auto n = static_cast<Index>(indices.size());
  return MatrixXd::NullaryExpr(n, n, [&](Index i, Index j) {
    return (*this)(indices[static_cast<std::size_t>(i)], indices[static_cast<std::size_t>(j)]);
  });
}

std::optional<LinearOperator::BlockSolver> LinearOperator::block_solver(double tolerance) const {
  const Toeplitz* matrix = toeplitz();
  if (matrix == nullptr) return std::nullopt;
  const double constant = matrix->is_symmetric() ? -(*matrix)(size() - 1, 0) : 0;
  return BlockSolver{constant, ToeplitzSubmatrix(matrix->plus(constant), tolerance)};
}

double LinearOperator::largest() const {
  if (entries() != nullptr) return entries()->cwiseAbs().maxCoeff();
  double largest = 0;
  for (Index k = 0; k < size(); ++k) {
    largest = std::max({largest, std::abs((*this)(k, 0)), std::abs((*this)(0, k))});
  }
  return largest;
}

void LinearOperator::apply(const VectorXd& x, VectorXd& y) const {
  if (const auto* by_fft = std::get_if<ByFft>(&matrix_)) {
    by_fft->product.apply(x, y);
  } else {
    count_work(2 * static_cast<double>(x.size() * x.size()));
    y.noalias() = (*entries()) * x;
  }
}

VectorXd LinearOperator::operator*(const VectorXd& x) const {
  VectorXd y;
  apply(x, y);
  return y;
}

}  // namespace microslip
