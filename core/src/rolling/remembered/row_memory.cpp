// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_memory.hpp"

#include <algorithm>
#include <cmath>

#include "../rolling_grid.hpp"
#include "stick_slip_point.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Returns where the nodes of a contact stand among the nodes of another contact.
/// \param travelled  by the contact's centre, in elements of the other contact
/// \param ratio      of half-widths, this contact's over the other's
NodeShift shift_of(const RowNodes& nodes, double travelled, double ratio) {
  return {.first = travelled + (ratio - 1) * nodes.first, .stretch = ratio - 1};
}

/// Returns the node at a remembered point, or else the next node ahead.
Index node_ahead(Index point, const NodeShift& shift) {
  return shift.of(point) < 0 ? point + 1 : point;
}

}  // namespace

double between_nodes(const VectorXd& values, Index point, const NodeShift& shift) {
  const Index ahead = node_ahead(point, shift);
  if (ahead == 0) return values[0];
  if (ahead >= values.size()) return values[values.size() - 1];
  const auto from_point = [&](Index node) { return static_cast<double>(node - point); };
  const double of_behind = (from_point(ahead) + shift.of(ahead)) / (1 + shift.stretch);
  const double of_ahead = -(from_point(ahead - 1) + shift.of(ahead - 1)) / (1 + shift.stretch);
  return of_behind * values[ahead - 1] + of_ahead * values[ahead];
}

NodeShift RowMemory::among_points() const {
  const double travelled = std::max(0.0, phase(row.spacing * counted_by));
  return shift_of(row, travelled, scale.half_width / counted_by);
}

SubstepEnd RowMemory::end_of_substep(double length, double end,
                                     const ContactScale& scale_at_end) const {
  const double element = row.spacing * counted_by;
  const double now = (end - origin) / element - entered;
  const double width = scale_at_end.half_width;
  SubstepEnd substep{
      .distance = end, .scale = scale_at_end, .on_points = {}, .on_nodes = {}, .is_whole = false};
  if (width == counted_by && width == scale.half_width) {
    substep.is_whole = now >= 1 - substep_rounding;
    substep.on_points.first = substep.is_whole ? 1 : now;
    substep.on_nodes.first = std::min(1.0, substep.on_points.first - std::max(0.0, phase(element)));
    return substep;
  }
  substep.on_points = shift_of(row, now, width / counted_by);
  substep.on_nodes =
      shift_of(row, length / (row.spacing * scale.half_width), width / scale.half_width);
  const double travelled =
      std::max(std::abs(substep.on_points.first), std::abs(substep.on_points.of(row.size)));
  substep.is_whole = travelled >= 1 - substep_rounding;
  return substep;
}

/// Looks a node up among the nodes when the substep began if the node has slipped, else among the
/// points.
RowMemory::Source RowMemory::source_of(Index i, const SubstepEnd& end) const {
  const bool as_if_stuck = (i >= kept && i < stuck) || (shifts && shifts->keeps(i));
  if (!sticks(zones, i) && !as_if_stuck) {
    return {.displacements = nodes,
            .shift = end.on_nodes.of(i),
            .from = 0,
            .half_width = scale.half_width};
  }
  return {.displacements = points,
          .shift = end.on_points.of(i),
          .from = i >= kept ? kept : 0,
          .half_width = counted_by};
}

double RowMemory::remembered_at(Index i, const SubstepEnd& end) const {
  const Source source = source_of(i, end);
  return interpolated_at(source.displacements, i, source.shift, source.from);
}

double RowMemory::slope_at_node(Index i, const SubstepEnd& end) const {
  const Source source = source_of(i, end);
  return slope_at(source.displacements, i, source.shift, source.from) /
         (row.spacing * source.half_width);
}

void RowMemory::remember_all() {
  points = nodes;
  stuck = first_stuck(zones);
  kept = stuck;
}

void RowMemory::admit_slip() {
  const NodeShift now = among_points();
  for (Index i = kept; i < std::min(stuck, row.size); ++i) {
    points.at[i] = between_nodes(nodes.at, i, now);
  }
  kept = stuck;
}

void RowMemory::admit_entry() {
  const Index n = row.size;
  points.at[n] = between_nodes(nodes.at, n, among_points());
}

bool RowMemory::entry_has_come(double offset) const {
  return among_points().of(row.size) >= 1 - offset;
}

std::pair<double, double> RowMemory::left_of_shift(const SubstepEnd& end) const {
  const double ahead_of_it = 1 - among_points().of(row.size);
  const double left = 1 - end.on_points.of(row.size);
  if (end.is_whole || left <= 0 || left > ahead_of_it) return {0, 0};
  return {left / ahead_of_it, -1 / (ahead_of_it * row.spacing * counted_by)};
}

/// Lets the points of the given indices slip with the nodes.
void RowMemory::slip_points(Index from, Index to) {
  const NodeShift now = among_points();
  VectorXd slip = VectorXd::Zero(row.size);
  for (Index i = from; i < to; ++i) {
    slip[i] = nodes.at[i] - interpolated_at(points, i, now.of(i), i >= kept ? kept : 0);
  }
  for (Index i = from; i < to; ++i) points.at[i] += between_nodes(slip, i, now);
}

/// Replaces the points by the points that are at nodes, entry and exit now.
/// \param from  points behind this index have slipped
void RowMemory::renew_points(const SubstepEnd& end, Index from) {
  const auto n = static_cast<Index>(zones.size());
  if (end.on_points.stretch == 0) {
    std::shift_left(points.at.begin(), points.at.end(), 1);
    entered += 1;
  } else {
    const RowPoints before = points;
    for (Index i = 0; i < n; ++i) {
      points.at[i] = interpolated_at(before, i, end.on_points.of(i), i >= from ? from : 0);
    }
    origin = end.distance;
    entered = 0;
    counted_by = end.scale.half_width;
  }
  points.at[n] = nodes.at[n] - ahead;
  points.exit = nodes.exit;
  ahead = 0;
}

void RowMemory::remember(const SubstepEnd& end, bool stuck_again) {
  const Index n = row.size;
  const Index kept_before = kept;
  stuck = first_stuck(zones);
  kept = stuck_again ? stuck : std::max<Index>(0, stuck - kept_behind);
  const auto has_slipped = [&](Index i) {
    return i < n && !sticks(zones, i) && (i < kept || i > stuck) && !(shifts && shifts->keeps(i));
  };
  if (end.is_whole) {
    renew_points(end, kept_before);
    for (Index i = 0; i < n; ++i) {
      if (has_slipped(i)) points.at[i] = nodes.at[i];
    }
    return;
  }
  const NodeShift& shift = end.on_points;
  for (Index i = 0; i < n; ++i) {
    const Index ahead = node_ahead(i, shift);
    const bool between = shift.of(i) != 0;
    if (!has_slipped(ahead) || (between && (ahead == 0 || sticks(zones, ahead - 1)))) continue;
    points.at[i] = between_nodes(nodes.at, i, shift);
  }
}

}  // namespace microslip
