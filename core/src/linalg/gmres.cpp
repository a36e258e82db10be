// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/gmres.hpp"

#include <cmath>

#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::VectorXd;

Gmres::Gmres(int most)
    : most_(most),
      hessenberg_(most + 1, most),
      cosines_(most),
      sines_(most),
      projected_(most + 1) {}

namespace {

/// Vector k of a list that is kept from solve to solve.
VectorXd& direction(std::vector<VectorXd>& of, int k) {
  const auto i = static_cast<std::size_t>(k);
  if (of.size() <= i) of.resize(i + 1);
  return of[i];
}

}  // namespace

/// Rotates column k by all previous rotations and by a new one, which makes its last entry vanish.
void Gmres::rotate_last_column(int k) {
  auto column = hessenberg_.col(k);
  for (int i = 0; i < k; ++i) {
    const double upper = column[i];
    column[i] = cosines_[i] * upper + sines_[i] * column[i + 1];
    column[i + 1] = cosines_[i] * column[i + 1] - sines_[i] * upper;
  }
  const double size = std::hypot(column[k], column[k + 1]);
  cosines_[k] = size > 0 ? column[k] / size : 1;
  sines_[k] = size > 0 ? column[k + 1] / size : 0;
  column[k] = size;
  projected_[k + 1] = -sines_[k] * projected_[k];
  projected_[k] *= cosines_[k];
}

Gmres::Outcome Gmres::solve(const Apply& matrix, const Apply& preconditioner, const VectorXd& b,
                            double tolerance, VectorXd& x) {
  x.setZero(b.size());
  const double size = b.norm();
  if (size == 0) return {0, 0};
  product_.resize(b.size());
  direction(directions_, 0) = b / size;
  projected_[0] = size;
  double residual = size;
  int k = 0;
  while (k < most_ && residual > tolerance * size) {
    preconditioner(direction(directions_, k), direction(trials_, k));
    matrix(direction(trials_, k), product_);
    // Orthogonalises twice: the second time removes the rounding errors of the first.
    count_work(static_cast<double>((8 * k + 11) * b.size()));
    hessenberg_.col(k).head(k + 2).setZero();
    for (int pass = 0; pass < 2; ++pass) {
      for (int i = 0; i <= k; ++i) {
        const double part = direction(directions_, i).dot(product_);
        hessenberg_(i, k) += part;
        product_ -= part * direction(directions_, i);
      }
    }
    hessenberg_(k + 1, k) = product_.norm();
    const bool exhausted = !(hessenberg_(k + 1, k) > 0);
    if (!exhausted) direction(directions_, k + 1) = product_ / hessenberg_(k + 1, k);
    rotate_last_column(k);
    residual = std::abs(projected_[k + 1]);
    ++k;
    if (exhausted) break;
  }
  hessenberg_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solveInPlace(projected_.head(k));
  count_work(static_cast<double>(2 * k * b.size()));
  for (int i = 0; i < k; ++i) x += projected_[i] * direction(trials_, i);
  return {k, residual / size};
}

}  // namespace microslip
