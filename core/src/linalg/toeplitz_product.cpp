// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz_product.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

ToeplitzProduct::ToeplitzProduct(const Toeplitz& matrix)
    : size_(matrix.size()), fft_(RealFft::good_size(2 * size_)) {
  auto circulant = fft_.values();
  circulant.setZero();
  for (Index k = 0; k < size_; ++k) circulant[k] = matrix(k, 0);
  for (Index k = 1; k < size_; ++k) circulant[fft_.size() - k] = matrix(0, k);
  fft_.forward();
  symbol_ = fft_.spectrum() / static_cast<double>(fft_.size());
}

void ToeplitzProduct::apply(const VectorXd& x, VectorXd& y) const {
  fft_.values().head(size_) = x;
  fft_.values().tail(fft_.size() - size_).setZero();
  fft_.forward();
  fft_.spectrum().array() *= symbol_.array();
  fft_.backward();
  y = fft_.values().head(size_);
}

}  // namespace microslip
