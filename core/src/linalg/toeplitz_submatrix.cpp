// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz_submatrix.hpp"

#include "microslip/linalg/index_view.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int most_gmres_iterations = 100;

}  // namespace

ToeplitzSubmatrix::ToeplitzSubmatrix(const Toeplitz& matrix, double tolerance)
    : matrix_(matrix), tolerance_(tolerance), gmres_(most_gmres_iterations) {}

void ToeplitzSubmatrix::choose(const std::vector<Index>& indices) {
  const Index first = indices.front(), size = indices.back() - first + 1;
  indices_ = indices;
  for (Index& index : indices_) index -= first;
  if (!inverse_ || inverse_->size() != size) {
    product_.reset();
    inverse_.reset();  // before a new one takes memory
    inverse_.emplace(matrix_.leading(size));
  }
  if (missing() > 0 && !product_) product_.emplace(matrix_.leading(size));
}

/// Sets all_, which is zero between the chosen indices.
void ToeplitzSubmatrix::spread(const VectorXd& x) {
  all_.setZero(inverse_->size());
  all_(index_view(indices_)) = x;
}

void ToeplitzSubmatrix::gather(const VectorXd& all, VectorXd& x) const {
  x = all(index_view(indices_));
}

void ToeplitzSubmatrix::precondition(const VectorXd& x, VectorXd& y) {
  spread(x);
  inverse_->apply(all_, response_);
  gather(response_, y);
}

void ToeplitzSubmatrix::multiply(const VectorXd& x, VectorXd& y) {
  spread(x);
  product_->apply(all_, response_);
  gather(response_, y);
}

int ToeplitzSubmatrix::solve(const VectorXd& b, VectorXd& x) {
  if (missing() == 0) {
    inverse_->apply(b, x);
    return 0;
  }
  return gmres_
      .solve([this](const VectorXd& p, VectorXd& y) { multiply(p, y); },
             [this](const VectorXd& p, VectorXd& y) { precondition(p, y); }, b, tolerance_, x)
      .iterations;
}

double ToeplitzSubmatrix::condition() const { return inverse_->condition(); }

}  // namespace microslip
