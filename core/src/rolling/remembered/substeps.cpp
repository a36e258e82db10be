// SPDX-License-Identifier: GPL-3.0-or-later
#include "substeps.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace microslip {

namespace {

/// Returns the load of a part of a way.
/// \param before  force where the way begins  [N/mm]
ShiftLoad load_of(const Way& way, const WayPart& part, double before) {
  if (const auto* force = std::get_if<PrescribedForce>(&way.load)) {
    return PrescribedForce{std::lerp(before, force->value, part.end)};
  }
  return PrescribedShift{std::get<PrescribedShift>(way.load).value * (part.end - part.begin)};
}

/// Returns the derivatives of this load by creepage or force, and by the length of the way.
std::array<ShiftLoad, 2> load_slopes_of(const Way& way, const WayPart& part, double before) {
  const bool is_last = part.end == 1;
  if (const auto* force = std::get_if<PrescribedForce>(&way.load)) {
    const double by_length = is_last ? 0 : -(force->value - before) * part.end / way.length;
    return {PrescribedForce{part.end}, PrescribedForce{by_length}};
  }
  const double creepage = std::get<PrescribedShift>(way.load).value / way.length;
  return {PrescribedShift{part.length}, PrescribedShift{is_last ? creepage : 0}};
}

}  // namespace

Substep substep_of(const RowMemory& memory, const Way& way, const WayPart& part,
                   const ContactScale& start, double force, const ContactScale& target) {
  const bool is_last = part.end == 1;
  const ContactScale scale = is_last ? target : between(start, target, part.end);
  SubstepEnd end = memory.end_of_substep(part.length, part.distance, scale);
  end.is_whole = end.is_whole || part.is_whole;
  return {end, part.length, load_of(way, part, force), load_slopes_of(way, part, force), is_last};
}

WayPart next_part(const RowMemory& memory, double fraction, const RowMemory& start, double length,
                  const ContactScale& target) {
  const double element = memory.row.spacing * memory.counted_by;
  const auto travel_at = [&](double substep, double place) {
    const double ratio = between(start.scale, target, substep).half_width / memory.counted_by;
    const double centre =
        (start.distance + substep * length - memory.origin) / element - memory.entered;
    return centre + (ratio - 1) * place;
  };
  double first = 1;
  bool is_whole = false;
  for (const double place : {memory.row.first, memory.row.entry()}) {
    const double now = travel_at(fraction, place);
    const double change = travel_at(1, place) - now;
    const double left = (change > 0 ? 1 : -1) - now;
    if (std::abs(left) > std::abs(change)) continue;
    first = std::min(first, fraction + std::max(0.0, left / change) * (1 - fraction));
    is_whole = true;
  }
  if (first > 1 - substep_rounding) first = 1;
  return {.begin = fraction,
          .end = first,
          .length = (first - fraction) * length,
          .distance = start.distance + first * length,
          .is_whole = is_whole};
}

}  // namespace microslip
