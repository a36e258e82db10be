// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/material_window.hpp"

#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// An edge this close to an element's is on it: distances are sums  [dx]
constexpr double rounding = 1e-9;

}  // namespace

MaterialWindow::MaterialWindow(const TractionBound& bound, const Grid& grid,
                               MovingBound moving_bound, Index kept)
    : bound_(bound),
      moving_bound_(moving_bound),
      half_width_(grid.half_width()),
      spacing_(grid.spacing()),
      elements_(grid.size()),
      kept_(kept) {
  const double first = grid.half_width() + grid.nodes()[0];
  require(grid.leading_offset() == 0.5, "grid.leading_offset", grid.leading_offset(),
          "0.5 on a grid that is fixed to the material");
  require(std::abs(first / spacing_ - 0.5) < rounding, "grid.trailing_offset", first / spacing_,
          "0.5 on a grid that is fixed to the material");
}

/// Elements are numbered from 0 at the trailing edge where nothing has been rolled.
double MaterialWindow::leading_element(double distance) const {
  return std::ceil(static_cast<double>(elements_) + distance / spacing_ - rounding) - 1;
}

VectorXd MaterialWindow::x(double distance) const {
  const double leading = (leading_element(distance) + 0.5) * spacing_ - half_width_ - distance;
  return VectorXd::NullaryExpr(
      size(), [&](Index i) { return leading - static_cast<double>(size() - 1 - i) * spacing_; });
}

VectorXd MaterialWindow::bound(double distance) const {
  if (moving_bound_ == MovingBound::at_node) return bound_at(bound_, x(distance));
  return mean_bound_around(bound_, x(distance), spacing_);
}

Index MaterialWindow::elements_between(double before, double after) const {
  return static_cast<Index>(leading_element(after) - leading_element(before));
}

}  // namespace microslip
