// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/plane_convolution.hpp"

namespace microslip {

PlaneConvolution::PlaneConvolution(Index columns, Index rows)
    : columns_(columns),
      rows_(rows),
      stride_(2 * columns - 1),
      fft_(RealFft::good_size(2 * place(columns - 1, rows - 1) + 1)) {}

Eigen::VectorXcd PlaneConvolution::symbol(const Eigen::MatrixXd& coefficients) const {
  auto values = fft_.values();
  values.setZero();
  for (Index k = 1 - rows_; k < rows_; ++k) {
    for (Index i = 1 - columns_; i < columns_; ++i) {
      const Index at = place(i, k);
      values[at < 0 ? at + fft_.size() : at] = coefficients(i + columns_ - 1, k + rows_ - 1);
    }
  }
  fft_.forward();
  return fft_.spectrum() / static_cast<double>(fft_.size());
}

}  // namespace microslip
