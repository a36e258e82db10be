// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz.hpp"

#include <algorithm>
#include <cmath>
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

double Toeplitz::norm() const {
  double sum = column_.lpNorm<1>();
  double largest = sum;
  for (Eigen::Index j = 1; j < size(); ++j) {
    sum += std::abs(row_[j]) - std::abs(column_[size() - j]);
    largest = std::max(largest, sum);
  }
  return largest;
}

Eigen::MatrixXd Toeplitz::dense() const {
  return Eigen::MatrixXd::NullaryExpr(
      size(), size(), [this](Eigen::Index i, Eigen::Index j) { return (*this)(i, j); });
}

}  // namespace microslip
