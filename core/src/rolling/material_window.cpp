// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/material_window.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

MaterialWindow::MaterialWindow(const TractionBound& bound, const Grid& grid, double leading_offset)
    : bound_(bound),
      half_width_(grid.half_width()),
      spacing_(grid.spacing()),
      leading_offset_(leading_offset),
      elements_(grid.size()) {
  require_filling(grid, 2, "on a grid that is fixed to the material");
}

double MaterialWindow::inside(Index node, double phase) const {
  // Distance from the trailing edge's place for the node behind the contact, when aligned.
  const double behind = 2 * leading_offset_ - 1.5;
  return std::min(1.0, static_cast<double>(node) - behind - phase);
}

MaterialWindow::Leaving MaterialWindow::leaving(double phase) const {
  for (Index i = 0;; ++i) {
    if (const double part = inside(i, phase); part > rounding) return {i, part};
  }
}

/// Force of the contact up to a place when it slides  [N/mm]
double MaterialWindow::force_up_to(double x) const {
  return std::visit([x](const auto& g) { return g.integral(x); }, bound_);
}

void MaterialWindow::bound(double phase, double coming_share, VectorXd& means,
                           double ahead_share) const {
  const double whole = full_sliding_force(bound_);
  const double before_coming = force_up_to(half_width_ - (leading_offset_ + 0.5) * spacing_);
  const auto share = [&](double part) {
    return part > rounding ? part * (whole - before_coming) : 0;
  };
  const auto nodes = x(phase);
  means.resize(size());
  double before = 0;
  for (Index i = 0; i < size(); ++i) {
    double after = force_up_to(nodes[i] + spacing_ / 2);
    if (i == leading()) after = whole - share(coming_share);
    if (i == coming()) after = whole - share(ahead_share);
    if (i == ahead()) after = whole;
    means[i] = std::max(0.0, after - before) / spacing_;
    before = after;
  }
}

void MaterialWindow::let_leave(double phase, VectorXd& means) const {
  const auto [node, part] = leaving(phase);
  const double both = means.head(node + 2).sum();
  const double whole = force_up_to(leading_offset_ * spacing_ - half_width_) / spacing_;
  means.head(node).setZero();
  means[node] = std::min(part * whole, both);
  means[node + 1] = both - means[node];
}

VectorXd MaterialWindow::bound(double phase) const {
  VectorXd means;
  bound(phase, phase, means);
  return means;
}

}  // namespace microslip
