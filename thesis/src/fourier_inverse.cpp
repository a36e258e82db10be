// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/thesis/fourier_inverse.hpp"

#include "microslip/linalg/real_fft.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VectorXd rotated(const VectorXd& values, Index by) {
  const Index n = values.size();
  return VectorXd::NullaryExpr(n, [&](Index i) { return values[(i + by) % n]; });
}

}  // namespace

Index middle_index(Index n) { return (n - 1) / 2; }

VectorXd middle_column(const Toeplitz& matrix) {
  const Index n = matrix.size();
  return VectorXd::NullaryExpr(n, [&](Index i) { return matrix(i, middle_index(n)); });
}

VectorXd diagonal_first(const VectorXd& column) {
  return rotated(column, middle_index(column.size()));
}

VectorXcd fourier_coefficients(const VectorXd& values) {
  const Index n = values.size();
  RealFft fft(n);
  fft.values() = values;
  fft.forward();
  const auto half = fft.spectrum();
  return VectorXcd::NullaryExpr(
      n, [&](Index m) { return m <= n / 2 ? half[m] : std::conj(half[n - m]); });
}

VectorXcd reciprocals(const VectorXcd& coefficients) { return coefficients.cwiseInverse(); }

VectorXd inverse_transform(const VectorXcd& coefficients) {
  const Index n = coefficients.size();
  RealFft fft(n);
  fft.spectrum() = coefficients.head(n / 2 + 1);
  fft.backward();
  return fft.values() / static_cast<double>(n);
}

VectorXd diagonal_in_the_middle(const VectorXd& values) {
  return rotated(values, values.size() - middle_index(values.size()));
}

Toeplitz toeplitz_from_middle_column(const VectorXd& column) {
  const Index n = column.size();
  const Index middle = middle_index(n);
  const auto at = [&](Index offset) {
    const Index i = middle + offset;
    return i >= 0 && i < n ? column[i] : 0.0;
  };
  return {VectorXd::NullaryExpr(n, at), VectorXd::NullaryExpr(n, [&](Index k) { return at(-k); })};
}

VectorXd approximate_inverse_column(const Toeplitz& matrix, ZeroFrequency zero_frequency) {
  VectorXcd inverse = reciprocals(fourier_coefficients(diagonal_first(middle_column(matrix))));
  if (zero_frequency == ZeroFrequency::drop) inverse[0] = 0;
  return diagonal_in_the_middle(inverse_transform(inverse));
}

}  // namespace microslip
