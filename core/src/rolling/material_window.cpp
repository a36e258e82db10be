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
  const double first = (grid.half_width() + grid.nodes()[0]) / spacing_;
  require(grid.leading_offset() == 0.5, "grid.leading_offset", grid.leading_offset(),
          "0.5 on a grid that is fixed to the material");
  require(std::abs(first - 0.5) < rounding, "grid.trailing_offset", first,
          "0.5 on a grid that is fixed to the material");
}

/// Force of the contact before the element behind the leading node's when it slides  [N/mm]
double MaterialWindow::leading_force(double phase) const {
  const double end = half_width_ - (leading_offset_ + phase + 0.5) * spacing_;
  const auto behind = [&](const auto& g) { return g.integral(end); };
  return full_sliding_force(bound_) - std::visit(behind, bound_);
}

void MaterialWindow::bound(double phase, VectorXd& means) const {
  means.resize(size());
  // An end of an element is that of the next one, too.
  const auto set_means = [&](const auto& g) {
    const auto nodes = x(phase);
    double before = g.integral(nodes[0] - spacing_ / 2);
    for (Index i = 0; i < size(); ++i) {
      const double after = g.integral(nodes[i] + spacing_ / 2);
      means[i] = std::max(0.0, after - before) / spacing_;
      before = after;
    }
  };
  std::visit(set_means, bound_);
  means[ahead()] = 0;
  means[coming()] = phase > rounding ? phase * leading_force(0) / spacing_ : 0;
  means[leading()] = std::max(0.0, leading_force(phase) / spacing_ - means[coming()]);
}

VectorXd MaterialWindow::bound(double phase) const {
  VectorXd means;
  bound(phase, means);
  return means;
}

}  // namespace microslip
