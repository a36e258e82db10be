// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/toeplitz_submatrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/linalg/index_view.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Up to this size, LU factors are cheaper than transforms.
constexpr Index small = 64;

constexpr int most_iterations = 100;

}  // namespace

ToeplitzSubmatrix::ToeplitzSubmatrix(const Toeplitz& matrix, double tolerance)
    : matrix_(matrix),
      product_(matrix),
      tolerance_(tolerance),
      gmres_(most_iterations),
      all_(VectorXd::Zero(matrix.size())) {}

ToeplitzSubmatrix::Interval ToeplitzSubmatrix::inverted(Index first, Index size) const {
  const Toeplitz block = matrix_.leading(size);
  if (size <= small) {
    count_work(2.0 / 3 * std::pow(size, 3));
    return {first, size, SmallInverse(block.dense()), {}};
  }
  return {first, size, ToeplitzInverse(block), {}};
}

void ToeplitzSubmatrix::choose(const std::vector<Index>& indices) {
  indices_ = indices;
  std::vector<Interval> known = std::exchange(intervals_, {});
  std::vector<std::pair<Index, Index>> others;
  for (std::size_t begin = 0, end = 0; begin < indices.size(); begin = end) {
    while (end < indices.size() &&
           indices[end] - indices[begin] == static_cast<Index>(end - begin)) {
      ++end;
    }
    const auto first = static_cast<Index>(begin), size = static_cast<Index>(end - begin);
    const auto same = std::ranges::find(known, size, &Interval::size);
    if (same == known.end()) {
      others.emplace_back(first, size);
      continue;
    }
    intervals_.push_back(std::move(*same));
    intervals_.back().first = first;
    known.erase(same);
  }
  known.clear();  // before new ones take memory
  for (const auto& [first, size] : others) intervals_.push_back(inverted(first, size));
}

void ToeplitzSubmatrix::invert_intervals(const VectorXd& b, VectorXd& x) {
  x.resize(b.size());
  for (auto& [first, size, inverse, solution] : intervals_) {
    if (const auto* factors = std::get_if<SmallInverse>(&inverse)) {
      count_work(2 * static_cast<double>(size * size));
      x.segment(first, size) = factors->solve(b.segment(first, size));
    } else {
      std::get<ToeplitzInverse>(inverse).apply(b.segment(first, size), solution);
      x.segment(first, size) = solution;
    }
  }
}

void ToeplitzSubmatrix::multiply(const VectorXd& x, VectorXd& y) {
  all_.setZero();
  all_(index_view(indices_)) = x;
  product_.apply(all_, response_);
  y = response_(index_view(indices_));
}

void ToeplitzSubmatrix::solve(const VectorXd& b, VectorXd& x) {
  if (intervals_.size() == 1) return invert_intervals(b, x);
  gmres_.solve([this](const VectorXd& p, VectorXd& y) { multiply(p, y); },
               [this](const VectorXd& p, VectorXd& y) { invert_intervals(p, y); }, b, tolerance_,
               x);
}

double ToeplitzSubmatrix::condition() const {
  double worst = 1;
  for (const Interval& interval : intervals_) {
    const auto* factors = std::get_if<SmallInverse>(&interval.inverse);
    worst = std::max(worst, factors != nullptr
                                ? 1 / factors->rcond()
                                : std::get<ToeplitzInverse>(interval.inverse).condition());
  }
  return worst;
}

}  // namespace microslip
