// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_friction.hpp"

#include <algorithm>
#include <cmath>

#include "../rolling_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Interpolates ratios of points linearly to i + shift.
double ratio_at(const VectorXd& ratios, Index i, double shift) {
  take_whole_elements(i, shift);
  const Index last = ratios.size() - 1;
  return std::lerp(ratios[std::clamp<Index>(i, 0, last)], ratios[std::clamp<Index>(i + 1, 0, last)],
                   shift);
}

}  // namespace

/// Next to the stick-slip point, the slip of a node is counted since its adhesion.
void RowFriction::find_earlier_slip(const RowMemory& before, const Substep& substep) {
  const Index n = before.row.size;
  earlier_.setZero(n);
  before_.resize(n);
  for (Index i = 0; i < n; ++i) {
    before_[i] = ratio_at(before.friction.points, i, substep.on_points.of(i));
    if (i < before.kept || i >= before.stuck) continue;
    earlier_[i] = interpolated_at(before.nodes, i, substep.on_nodes.of(i), 0) -
                  before.remembered_at(i, substep);
  }
}

void RowFriction::solve(ActiveSet& active_set, RowStep& step, const Substep& substep) {
  SlipConditions& conditions = step.conditions;
  const ShiftLoad load = step.of_partition(substep.load);
  conditions.bound = at_rest_;
  if (substep.length == 0) {
    conditions.bound = at_rest_.cwiseProduct(step.memory.friction.nodes);
    active_set.solve(conditions, load, step.contact);
    return;
  }
  find_earlier_slip(step.memory, substep);
  distance_.resize(earlier_.size());
  const double time = time_of(substep);
  const auto ratio_of = [&](const VectorXd& slip, VectorXd& ratio) {
    for (Index i = 0; i < slip.size(); ++i) {
      const double by = slip[i] > 0 ? slip[i] - earlier_[i] : earlier_[i] - slip[i];
      distance_[i] = slip[i] == 0 ? 0 : std::max(0.0, by);
      ratio[i] = friction_.ratio_after(before_[i], distance_[i], time);
    }
  };
  search_.solve(active_set, conditions, load, ratio_of, step.contact);
  has_second_ = has_second_ || search_.has_second();
}

void RowFriction::remember(RowMemory& memory, const Substep& substep, double offset) const {
  if (substep.length == 0) return;
  const Index n = memory.row.size;
  VectorXd& points = memory.friction.points;
  memory.friction.nodes = search_.ratio();
  if (substep.is_whole) {
    points.head(n) = search_.ratio();
    points[n] = 1;
    return;
  }
  const double time = time_of(substep);
  const Index come = memory.entry_has_come(offset) ? n + 1 : n;
  for (Index i = 0; i < come; ++i) {
    const double slipped = between_nodes(distance_, i, substep.on_points);
    points[i] = friction_.ratio_after(points[i], slipped, time);
  }
}

}  // namespace microslip
