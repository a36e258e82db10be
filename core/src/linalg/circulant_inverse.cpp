// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/circulant_inverse.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

CirculantInverse::CirculantInverse(const Toeplitz& matrix)
    : size_(matrix.size()), fft_(RealFft::good_size(size_)) {
  const Index m = fft_.size();
  const auto entry = [&](Index k) {
    return k >= size_ || k <= -size_ ? 0 : k >= 0 ? matrix(k, 0) : matrix(0, -k);
  };
  for (Index k = 0; k < m; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(m);
    fft_.values()[k] = (1 - part) * entry(k) + part * entry(k - m);
  }
  fft_.forward();
  symbol_ = (static_cast<double>(m) * fft_.spectrum()).cwiseInverse();
}

void CirculantInverse::apply(const VectorXd& b, VectorXd& x) const {
  fft_.values().head(size_) = b;
  fft_.values().tail(fft_.size() - size_).setZero();
  fft_.forward();
  fft_.spectrum().array() *= symbol_.array();
  fft_.backward();
  x = fft_.values().head(size_);
}

}  // namespace microslip
