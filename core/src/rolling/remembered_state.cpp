// SPDX-License-Identifier: GPL-3.0-or-later
#include "remembered_state.hpp"

#include <algorithm>
#include <cmath>

#include "rolling_grid.hpp"
#include "stick_slip_point.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Points that slipped at most so many elements behind the stick-slip point are kept as if they had
/// not slipped, because the averaged partitions include their nodes in adhesion.
constexpr Index kept_behind = 3;

/// So many nodes in adhesion next to its leading end may slip in the mean over partitions.
constexpr Index averaged = 2;

/// Returns where the nodes of a contact stand among the nodes of another contact.
/// \param travelled  by the contact's centre, in elements of the other contact
/// \param ratio      of half-widths, this contact's over the other's
NodeShift shift_of(const ReferenceNodes& nodes, double travelled, double ratio) {
  return {.first = travelled + (ratio - 1) * nodes.first, .stretch = ratio - 1};
}

/// Returns the node at a remembered point, or else the next node ahead.
Index node_ahead(Index point, const NodeShift& shift) {
  return shift.of(point) < 0 ? point + 1 : point;
}

/// Interpolates present values to a remembered point, linearly between the nodes on either side.
/// \param values  at the nodes; constant behind the first and ahead of the last
double between_nodes(const VectorXd& values, Index point, const NodeShift& shift) {
  const Index ahead = node_ahead(point, shift);
  if (ahead == 0) return values[0];
  if (ahead >= values.size()) return values[values.size() - 1];
  const auto from_point = [&](Index node) { return static_cast<double>(node - point); };
  const double of_behind = (from_point(ahead) + shift.of(ahead)) / (1 + shift.stretch);
  const double of_ahead = -(from_point(ahead - 1) + shift.of(ahead - 1)) / (1 + shift.stretch);
  return of_behind * values[ahead - 1] + of_ahead * values[ahead];
}

}  // namespace

NodeShift RememberedState::among_points(const ReferenceNodes& nodes) const {
  const double travelled = std::max(0.0, phase(nodes.spacing * counted_by));
  return shift_of(nodes, travelled, scale.half_width / counted_by);
}

SubstepEnd RememberedState::end_of_substep(const ReferenceNodes& nodes, double length, double end,
                                           const ContactScale& scale_at_end) const {
  const double element = nodes.spacing * counted_by;
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
  substep.on_points = shift_of(nodes, now, width / counted_by);
  substep.on_nodes =
      shift_of(nodes, length / (nodes.spacing * scale.half_width), width / scale.half_width);
  const double travelled =
      std::max(std::abs(substep.on_points.first), std::abs(substep.on_points.of(nodes.size)));
  substep.is_whole = travelled >= 1 - substep_rounding;
  return substep;
}

/// Looks a node up among the nodes when the substep began if the node has slipped, else among the
/// points.
RememberedState::Source RememberedState::source_of(Index i, const SubstepEnd& end) const {
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

double RememberedState::remembered_at(Index i, const SubstepEnd& end) const {
  const Source source = source_of(i, end);
  return interpolated_at(source.displacements, i, source.shift, source.from);
}

double RememberedState::slope_at_node(const ReferenceNodes& reference, Index i,
                                      const SubstepEnd& end) const {
  const Source source = source_of(i, end);
  return slope_at(source.displacements, i, source.shift, source.from) /
         (reference.spacing * source.half_width);
}

void RememberedState::remember_all() {
  points = nodes;
  stuck = first_stuck(zones);
  kept = stuck;
}

void RememberedState::admit_slip(const ReferenceNodes& reference) {
  const NodeShift now = among_points(reference);
  for (Index i = kept; i < std::min(stuck, reference.size); ++i) {
    points.at[i] = between_nodes(nodes.at, i, now);
  }
  kept = stuck;
}

void RememberedState::admit_entry(const ReferenceNodes& reference) {
  const Index n = reference.size;
  points.at[n] = between_nodes(nodes.at, n, among_points(reference));
}

bool RememberedState::entry_has_come(const ReferenceNodes& reference, double offset) const {
  return among_points(reference).of(reference.size) >= 1 - offset;
}

std::pair<double, double> RememberedState::left_of_shift(const ReferenceNodes& reference,
                                                         const SubstepEnd& end) const {
  const double ahead_of_it = 1 - among_points(reference).of(reference.size);
  const double left = 1 - end.on_points.of(reference.size);
  if (end.is_whole || left <= 0 || left > ahead_of_it) return {0, 0};
  return {left / ahead_of_it, -1 / (ahead_of_it * reference.spacing * counted_by)};
}

MeanChange& MeanChange::operator+=(const MeanChange& other) {
  traction += other.traction;
  displacement += other.displacement;
  shift += other.shift;
  return *this;
}

void RememberedState::begin_shifts(double spring) {
  if (shifts) return;
  const VectorXd none = VectorXd::Zero(nodes.at.size());
  shifts.emplace();
  shifts->before_turn = {.traction = none, .displacement = none};
  shifts->at_entry = nodes.at[nodes.at.size() - 1] + spring * entry;
}

void RememberedState::go(const ReferenceNodes& reference, double toward) {
  const bool turns = toward * shifts->toward < 0;
  if (toward != 0) shifts->toward = toward;
  if (!turns) return;
  const Index n = reference.size;
  VectorXd& reversal = shifts->reversal;
  reversal.resize(n + 1);
  reversal << traction, entry;
  reversal[n - 1] -= entry;
  reversal -= shifts->mean.traction;
  admit_slip(reference);
  admit_leading_slip(reference);
  shifts->before_turn = shifts->mean;
}

void RememberedState::remember_shift(const ReferenceNodes& reference, const SubstepEnd& end,
                                     const std::vector<Zone>& with_entry, bool stuck_again) {
  const Index n = reference.size;
  zones.assign(with_entry.begin(), with_entry.end() - 1);
  shifts->leading = past_last_stuck(with_entry);
  shifts->leading_kept = std::min(n, shifts->leading + kept_behind) + 1;
  if (shifts->leading_kept <= n) shifts->at_entry = shifts->entry_displaced;
  remember(reference, end, stuck_again);
}

/// Lets the points of the given indices slip with the nodes.
void RememberedState::slip_points(const ReferenceNodes& reference, Index from, Index to) {
  const NodeShift now = among_points(reference);
  VectorXd slip = VectorXd::Zero(reference.size);
  for (Index i = from; i < to; ++i) {
    slip[i] = nodes.at[i] - interpolated_at(points, i, now.of(i), i >= kept ? kept : 0);
  }
  for (Index i = from; i < to; ++i) points.at[i] += between_nodes(slip, i, now);
}

void RememberedState::admit_leading_slip(const ReferenceNodes& reference) {
  slip_points(reference, shifts->leading, std::min(shifts->leading_kept, reference.size));
  shifts->at_entry = shifts->entry_displaced;
  shifts->leading_kept = shifts->leading;
}

void RememberedState::end_shifts(const ReferenceNodes& reference, const VectorXd& bound) {
  const VectorXd& displacement = shifts->leading_mean.displacement;
  const double shift = shifts->leading_mean.shift;
  const Index leading = shifts->leading;
  points.subtract(shift);
  nodes.at.head(reference.size) += displacement.head(reference.size);
  nodes.at[reference.size] -= shift;
  nodes.exit -= shift;
  lead -= shift;
  slip_points(reference, std::max(kept, leading - averaged),
              std::min(shifts->leading_kept, reference.size));
  if (leading > reference.size) {
    share_slip(reference, shifts->entry_slip / (1 - entry_share));
  } else {
    admit_entry(reference);
  }
  if (leading < reference.size) {
    relief = VectorXd::Zero(reference.size);
    const Index slipping = reference.size - leading;
    relief.tail(slipping) = traction.tail(slipping);
    relief[reference.size - 1] -= entry;
    relief.tail(slipping) = bound.tail(slipping) - relief.tail(slipping).cwiseAbs();
  }
  shifts.reset();
}

/// Shares the slip at the entry between the last point and the next one. The scheme feels the edge
/// of a shift, at which tractions are singular, `offset` - 1/2 elements ahead of the last point
/// that sticks. So the fraction t of the last point sticks, and the fraction t - 1 of the next
/// point, which is not remembered yet.
/// \param slip  at the entry, of material that is outside  [mm]
void RememberedState::share_slip(const ReferenceNodes& reference, double slip) {
  const Index n = reference.size;
  const double inside = among_points(reference).of(n) + 0.5;
  points.at[n] += std::max(0.0, 1 - inside) * slip;
  ahead += std::max(0.0, inside - 1) * slip;
}

/// Replaces the points by the points that are at nodes, entry and exit now.
/// \param from  points behind this index have slipped
void RememberedState::renew_points(const SubstepEnd& end, Index from) {
  const auto n = static_cast<Index>(zones.size());
  if (end.on_points.stretch == 0) {
    std::shift_left(points.at.begin(), points.at.end(), 1);
    entered += 1;
  } else {
    const RememberedPoints before = points;
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

void RememberedState::remember(const ReferenceNodes& reference, const SubstepEnd& end,
                               bool stuck_again) {
  const Index n = reference.size;
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

NextSubstep next_substep(const RememberedState& state, const ReferenceNodes& nodes, double fraction,
                         double start, double length, const ContactScale& from,
                         const ContactScale& to) {
  const double element = nodes.spacing * state.counted_by;
  const auto travel_at = [&](double substep, double place) {
    const double ratio = between(from, to, substep).half_width / state.counted_by;
    const double centre = (start + substep * length - state.origin) / element - state.entered;
    return centre + (ratio - 1) * place;
  };
  NextSubstep next{.end = 1, .is_whole = false};
  for (const double place : {nodes.first, nodes.entry()}) {
    const double now = travel_at(fraction, place);
    const double change = travel_at(1, place) - now;
    const double left = (change > 0 ? 1 : -1) - now;
    if (std::abs(left) > std::abs(change)) continue;
    const double end = fraction + std::max(0.0, left / change) * (1 - fraction);
    next = {.end = std::min(next.end, end), .is_whole = true};
  }
  if (next.end > 1 - substep_rounding) next.end = 1;
  return next;
}

}  // namespace microslip
