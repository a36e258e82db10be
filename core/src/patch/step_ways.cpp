// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_ways.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

using Eigen::Index;

namespace {

/// Steps over the longest cell, up to which slip is that of the material, and from which it is that
/// seen from the contact. In steps of a mean cell it is that of the material.
constexpr double short_step = 0.7, long_step = 1.2;

}  // namespace

StepWays::StepWays(const JoinedRows& rows, const PatchStep& step) : rows_(rows), step_(step) {
  if (step.from != step.to) return;
  double longest = 0;
  for (Index k = 0; k < rows.rows(); ++k) {
    longest = std::max(longest, length(rows.elements() / 2, k));
  }
  part_in_contact_ =
      std::clamp((step.dq / longest - short_step) / (long_step - short_step), 0.0, 1.0);
}

/// The part of the step at which material enters that ends at x: 0 if it was in the contact before.
/// With t from 0 to 1 and the size r(t) of an ellipse, it is within where
///   f(t) = r(t)^2 - (x + (1 - t) dq)^2/a^2 - y^2/b^2 >= 0,
/// a quadratic function.
double StepWays::entry(double x, Index k) const {
  const auto& [dq, from, to, ratio] = step_;
  const double way = this->x(0, k) - x;
  if (from == to) return way >= dq ? 0 : 1 - way / dq;
  const double a = rows_.shape().half_width(), b = rows_.shape().lateral_half_width();
  const double grown = to - from, begin = (x + dq) / a, passed = dq / a, y = to * rows_.y(k) / b;
  const double before = from * from - begin * begin - y * y;
  if (before >= 0) return 0;
  const double square = grown * grown - passed * passed;
  const double half = from * grown + begin * passed;
  const double root = std::sqrt(std::max(0.0, half * half - square * before));
  // It is outside at t = 0 and within at t = 1, so that this is the root between both.
  return std::clamp(-before / (half + root), 0.0, 1 - 1e-9);
}

MaterialWay StepWays::way_to(double x, Index k) const {
  const double entered = entry(x, k);
  return {x, step_.dq * (1 - entered), entered};
}

MaterialWay StepWays::about_centre(Index i, Index k) const {
  const MaterialWay way = way_to(std::max(x(2 * i + 1, k) - step_.dq / 2, x(2 * i + 2, k)), k);
  const MaterialWay centre = to_centre(i, k);
  return way.entered > centre.entered ? centre : way;
}

double StepWays::by_change_of_motion(const MaterialWay& way) const {
  if (way.entered == 0) return 0;
  return (EntryWeights(way.entered, step_.ratio).now - way.entered) * step_.dq;
}

Eigen::Matrix<double, 2, 3> StepWays::rigid_slip_at_edge(Index k) const {
  return Eigen::Matrix<double, 2, 3>{{1, 0, -step_.to * rows_.y(k)}, {0, 1, x(0, k)}};
}

/// Adds the part of the motion in the displacement at entry.
void StepWays::add_entry(PatchSlipMap& map, Index i, Index k, const MaterialWay& way) const {
  const double part = by_change_of_motion(way) / way.length;
  const auto by_motion = rigid_slip_at_edge(k);
  const Index cell = rows_.cell(i, k);
  map.by_motion.row(cell) -= part * by_motion.row(0);
  map.by_motion.row(rows_.cells() + cell) -= part * by_motion.row(1);
}

PointSlip StepWays::slip_about(const MaterialWay& way, Index k) const {
  PointSlip slip = between(rows_, rows_.theta_of(way.x / step_.to, k));
  for (double& weight : slip.weights) weight *= step_.to / way.length;
  slip.points[4] = 0;
  slip.weights[4] = -EntryWeights(way.entered, step_.ratio).now * step_.to / way.length;
  slip.x = way.x + way.length / 2;
  return slip;
}

/// On a longer way than a cell, displacements resolve the logarithm.
double StepWays::part_at_pole(Index i, Index k) const {
  const double of_way = std::min(1.0, length(i, k) / about_centre(i, k).length);
  return std::lerp(of_way, 1.0, part_in_contact_);
}

/// Mixes slip at centres with that seen from the contact.
void StepWays::mix_slip_in_contact(PatchSlipMap& map,
                                   const PatchResponse::Matrix& displacement) const {
  const double part = part_in_contact_;
  if (part == 0) return;
  PatchSlipMap seen = map_for(rows_);
  for (Index k = 0; k < rows_.rows(); ++k) {
    for (Index i = 0; i < rows_.elements(); ++i) {
      PointSlip slip = centre_slip(rows_, i, k);
      slip.weights[4] = step_.to / step_.dq;
      slip.x = x(2 * i + 1, k);
      set_slip(seen, rows_, displacement, i, k, slip, step_.to * rows_.y(k));
    }
  }
  map.by_traction += part * (seen.by_traction - map.by_traction);
  map.by_motion += part * (seen.by_motion - map.by_motion);
}

SeenSlip StepWays::seen() const {
  SeenSlip seen = SeenSlip::steady(rows_.cells());
  for (Index k = 0; k < rows_.rows(); ++k) {
    for (Index i = 1; i < rows_.elements(); ++i) {
      const Index cell = rows_.cell(i, k);
      const double way = step_.dq / distance_ahead(i, k);
      if (!is_seen(i, k)) {
        seen.ways[cell] = to_centre(i, k).length / distance_ahead(i, k);
        continue;
      }
      seen.by_own[cell] = part_seen(i, k) * (1 + way) / 2;
      seen.by_ahead[cell] = part_seen(i, k) * (1 - way) / 2;
    }
  }
  return seen;
}

PatchResponse StepWays::response(const PatchResponse::Matrix& displacement) const {
  PatchSlipMap own = map_for(rows_), at_centre = map_for(rows_);
  const double size = step_.to;
  for (Index k = 0; k < rows_.rows(); ++k) {
    for (Index i = 0; i < rows_.elements(); ++i) {
      const Index here = 2 * i + 1;
      const double y = size * rows_.y(k);
      if (step_.dq == 0) {
        const PointSlip shifted{{here}, {size}, x(here, k)};
        set_slip(own, rows_, displacement, i, k, shifted, y);
        set_slip(at_centre, rows_, displacement, i, k, shifted, y);
        continue;
      }
      const MaterialWay way = to_centre(i, k);
      const double entering = EntryWeights(way.entered, step_.ratio).now;
      const PointSlip slip{
          {here, 0}, {size / way.length, -entering * size / way.length}, way.x + way.length / 2};
      set_slip(own, rows_, displacement, i, k, slip, y);
      add_entry(own, i, k, way);
      const MaterialWay about = about_centre(i, k);
      set_slip(at_centre, rows_, displacement, i, k, slip_about(about, k), y);
      add_entry(at_centre, i, k, about);
    }
  }
  if (step_.dq == 0) return {rows_, own, at_centre, {}, {}};
  mix_slip_in_contact(at_centre, displacement);
  return {rows_, own, at_centre,
          map_pole(rows_, [&](Index i, Index k) { return part_at_pole(i, k); }), seen()};
}

}  // namespace microslip
