// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz.hpp"

#include <stdexcept>

namespace microslip {

Toeplitz::Toeplitz(Eigen::VectorXd column, Eigen::VectorXd row)
    : column_(std::move(column)), row_(std::move(row)) {
  if (column_.size() == 0 || column_.size() != row_.size() || column_[0] != row_[0]) {
    throw std::invalid_argument("Toeplitz: column and row must agree in size and first entry");
  }
}

Toeplitz Toeplitz::leading(Eigen::Index n) const { return {column_.head(n), row_.head(n)}; }

Toeplitz Toeplitz::plus(double constant) const {
  return {column_.array() + constant, row_.array() + constant};
}

Toeplitz Toeplitz::times(double factor) const { return {column_ * factor, row_ * factor}; }

Eigen::MatrixXd Toeplitz::dense() const {
  return Eigen::MatrixXd::NullaryExpr(
      size(), size(), [this](Eigen::Index i, Eigen::Index j) { return (*this)(i, j); });
}

}  // namespace microslip
