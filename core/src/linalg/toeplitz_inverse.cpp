// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz_inverse.hpp"

#include <algorithm>

#include "microslip/linalg/circulant_inverse.hpp"
#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/inverse_norm.hpp"
#include "microslip/linalg/toeplitz_product.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

constexpr int most_iterations = 100;

/// Residual at which GMRES ends; it is a rounding error.
constexpr double smallest_residual = 1e-15;

/// Columns with a larger residual give an inverse that refinement cannot repair.
constexpr double acceptable = 1e-6;

/// (0, v_0, ..., v_(n-2))
VectorXd moved_down(const VectorXd& v) {
  VectorXd moved(v.size());
  moved << 0, v.head(v.size() - 1);
  return moved;
}

}  // namespace

ToeplitzInverse::ToeplitzInverse(const Toeplitz& matrix)
    : size_(matrix.size()), norm_(matrix.norm()), fft_(RealFft::good_size(2 * size_)) {
  const ToeplitzProduct product(matrix);
  const CirculantInverse circulant(matrix);
  Gmres gmres(most_iterations);
  const auto column = [&](Index of) {
    const VectorXd unit = VectorXd::Unit(size_, of);
    VectorXd x, back;
    const int iterations =
        gmres
            .solve([&](const VectorXd& p, VectorXd& y) { product.apply(p, y); },
                   [&](const VectorXd& p, VectorXd& y) { circulant.apply(p, y); }, unit,
                   smallest_residual, x)
            .iterations;
    product.apply(x, back);
    const double residual = (back - unit).norm();
    iterations_ = std::max(iterations_, iterations);
    if (!(residual <= acceptable)) {
      throw NotConverged("inverse of a Toeplitz matrix", iterations, residual);
    }
    return x;
  };
  const VectorXd first = column(0);
  const VectorXd last = matrix.is_symmetric() ? first.reverse().eval() : column(size_ - 1);
  const double scale = static_cast<double>(fft_.size());
  first_lower_ = lower(first) / (first[0] * scale);
  first_upper_ = upper(last.reverse()) / scale;
  second_lower_ = lower(moved_down(last)) / (-first[0] * scale);
  second_upper_ = upper(moved_down(first.reverse())) / scale;
}

VectorXcd ToeplitzInverse::lower(const VectorXd& first_column) {
  fft_.values().setZero();
  fft_.values().head(size_) = first_column;
  fft_.forward();
  return fft_.spectrum();
}

VectorXcd ToeplitzInverse::upper(const VectorXd& first_row) {
  fft_.values().setZero();
  fft_.values()[0] = first_row[0];
  fft_.values().tail(size_ - 1) = first_row.tail(size_ - 1).reverse();
  fft_.forward();
  return fft_.spectrum();
}

void ToeplitzInverse::apply(const Eigen::Ref<const VectorXd>& b, VectorXd& x) const {
  const Index beyond = fft_.size() - size_;
  fft_.values().head(size_) = b;
  fft_.values().tail(beyond).setZero();
  fft_.forward();
  spectrum_ = fft_.spectrum();
  const auto by_upper = [&](const VectorXcd& upper) {
    fft_.spectrum().array() = spectrum_.array() * upper.array();
    fft_.backward();
    fft_.values().tail(beyond).setZero();
    fft_.forward();
  };
  by_upper(first_upper_);
  sum_ = fft_.spectrum().cwiseProduct(first_lower_);
  by_upper(second_upper_);
  fft_.spectrum().array() = sum_.array() + fft_.spectrum().array() * second_lower_.array();
  fft_.backward();
  x = fft_.values().head(size_);
}

/// Turned upside down and left to right, a Toeplitz matrix is its transpose.
double ToeplitzInverse::condition() const {
  VectorXd solution;
  const auto solve = [&](VectorXd& x) {
    apply(x, solution);
    x = solution;
  };
  const auto solve_transposed = [&](VectorXd& x) {
    apply(x.reverse(), solution);
    x = solution.reverse();
  };
  return norm_ * inverse_norm(size_, solve, solve_transposed);
}

}  // namespace microslip
