// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/bound_defect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Phases repeat if the steps are equal, but for rounding  [dx]
constexpr double resolution = 1e-12;

/// Steps down to 1/1000 of an element find all their phases again, but for large N: steps that
/// never do would fill 80 MB.
constexpr Index most_known = 1100;
constexpr Index most_numbers = 10'000'000;

/// Below this the difference of two values would lose too many digits  [dx]
constexpr double short_step = 1e-4;

}  // namespace

BoundDefect::BoundDefect(const Kernel& kernel, const TractionBound& bound,
                         const MaterialWindow& window)
    : sliding_(kernel, bound), window_(window) {}

const VectorXd& BoundDefect::at(double phase, const SquareMatrix& response) const {
  const long long key = std::llround(phase / resolution);
  if (const auto known = known_.find(key); known != known_.end()) return *known->second;
  const Index most = std::clamp<Index>(most_numbers / window_.size(), 2, most_known);
  if (static_cast<Index>(known_.size()) >= most) known_.clear();
  // Of the rounded phase, so that it does not matter which one came first.
  const double rounded = static_cast<double>(key) * resolution;
  window_.bound(rounded, bound_);
  response.apply(bound_, by_elements_);
  const auto exact = [&](double x) { return sliding_.displacement(x); };
  auto defect =
      std::make_shared<const VectorXd>(window_.x(rounded).unaryExpr(exact) - by_elements_);
  return *known_.emplace(key, std::move(defect)).first->second;
}

void BoundDefect::change(double before, double after, Index moved, double length,
                         const SquareMatrix& response, VectorXd& change) const {
  if (length >= short_step * window_.spacing()) {
    change = at(before, response);
    move_on(change, moved, 0.0);
    change = at(after, response) - change;
  } else {
    window_.bound(before, bound_before_);
    move_on(bound_before_, moved, 0.0);
    window_.bound(after, bound_);
    bound_ -= bound_before_;
    response.apply(bound_, by_elements_);
    const auto exact = [&](double x) { return sliding_.difference(x, length); };
    change = window_.x(after).unaryExpr(exact) - by_elements_;
  }
  change.tail(moved).setZero();
}

}  // namespace microslip
