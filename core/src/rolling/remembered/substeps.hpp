// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "microslip/friction/load.hpp"
#include "row_memory.hpp"

namespace microslip {

/// A step; if its length is 0, a shift without rolling.
struct Way {
  double length;  ///< [mm]
  ShiftLoad load;
};

/// A part of a way, on which neither edge of the contact travels more than an element.
struct WayPart {
  double begin, end;  ///< fractions of the way
  double length;      ///< [mm]
  double distance;    ///< rolled at its end  [mm]
  bool is_whole;      ///< whether an edge of a contact that changes has travelled an element there
};

/// A part of a way with its load.
struct Substep : SubstepEnd {
  double length;  ///< [mm]
  ShiftLoad load;
  std::array<ShiftLoad, 2> load_slopes;  ///< by load and length of the step
  bool is_last;
};

/// Makes the substep of a part of a way: its part of the shift, or the force at its end. The force
/// changes linearly on the way. A longer step has a longer last substep; at the end of an earlier
/// substep, its force has changed by a smaller fraction.
/// \param memory  where the substep begins
/// \param start   where the way begins
/// \param force   there  [N/mm]
/// \param target  the contact where the way ends
Substep substep_of(const RowMemory& memory, const Way& way, const WayPart& part,
                   const ContactScale& start, double force, const ContactScale& target);

/// Finds the next part on a contact that changes. It ends where the leading or the trailing edge
/// has travelled an element, forth or back, or with the way. The length of the element is the one
/// by which the memory counts.
/// \param memory    at the beginning of the part
/// \param fraction  of the way there
/// \param start     where the way begins
/// \param target    the contact where the way ends
WayPart next_part(const RowMemory& memory, double fraction, const RowMemory& start, double length,
                  const ContactScale& target);

/// Divides a way into parts. A part ends where an element has been travelled; on a contact that
/// changes, by whichever edge is first.
/// \param start   where the way begins
/// \param memory  moved from there by `roll`, to the end of a part
/// \param target  the contact where the way ends
/// \param roll    called with each part
/// \return        the distance_error at the end of the way  [mm]
/// \throws std::invalid_argument if the length is below min_step_ratio dx
template <class Roll>
double for_each_part(const RowMemory& start, const RowMemory& memory, const Way& way,
                     const ContactScale& target, const Roll& roll) {
  const double width = start.scale.half_width;
  const double spacing = start.row.spacing * width;
  const bool keeps_width = target.half_width == width;
  if (way.length > 0 && keeps_width && start.counted_by == width) {
    return for_each_element(start, way.length, spacing,
                            [&](double length, double distance, double rest) {
                              roll(WayPart{.begin = 1 - (length + rest) / way.length,
                                           .end = rest == 0 ? 1 : 1 - rest / way.length,
                                           .length = length,
                                           .distance = distance,
                                           .is_whole = false});
                            });
  }
  if (way.length > 0) require_step_ratio(way.length / spacing);
  const double added = way.length - start.distance_error;
  const double end = start.distance + added;
  for (double fraction = 0; fraction < 1;) {
    WayPart part{.begin = 0, .end = 1, .length = 0, .distance = end, .is_whole = false};
    if (!keeps_width || way.length > 0) {
      part = next_part(memory, fraction, start, way.length, target);
      if (part.end == 1) part.distance = end;
    }
    roll(part);
    fraction = part.end;
  }
  return (end - start.distance) - added;
}

}  // namespace microslip
