// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

/// A part of an element that is smaller than this is none: distances are sums.
constexpr double part_rounding = 1e-9;

/// The way that a contact has rolled over the elements of its material.
struct ElementTravel {
  double distance = 0;        ///< rolled  [mm]
  double distance_error = 0;  ///< that rounding added to it  [mm]
  double origin = 0;          ///< distance from which elements are counted  [mm]
  double entered = 0;         ///< whole elements travelled since then

  /// The part of an element travelled since the last whole one. The spacing is that of the nodes,
  /// dx [mm]
  double phase(double spacing) const { return (distance - origin) / spacing - entered; }

  /// Takes the same place with fewer rounding errors.
  void move_to(double at) {
    distance = at;
    distance_error = 0;
  }
};

/// \param ratio  a step's length over the spacing
/// \throws std::invalid_argument below min_step_ratio
inline void require_step(double ratio) {
  require(ratio >= min_step_ratio, "step_ratio", ratio, "a number >= 1e-15");
}

/// Divides a step into parts, each of which ends where an element has been travelled, or with the
/// step. Sums of distances are compensated, or steps of whole elements would be divided after some
/// ten thousand.
/// \param start    at the beginning of the step
/// \param length   of the step  [mm]
/// \param spacing  dx  [mm]
/// \param part     called with the length of each part, the distance at its end, and what is left
///                 of the step after it  [mm]
/// \return         the distance_error at the end of the step  [mm]
/// \throws std::invalid_argument if the length is below min_step_ratio dx
template <class Part>
double for_each_part(const ElementTravel& start, double length, double spacing, const Part& part) {
  require_step(length / spacing);
  const double added = length - start.distance_error;
  const double end = start.distance + added;
  double from = start.distance;
  double rest = length;
  for (double next = start.entered + 1; (end - start.origin) / spacing - next > part_rounding;
       ++next) {
    const double to = start.origin + next * spacing;
    rest -= to - from;
    part(to - from, to, rest);
    from = to;
  }
  part(rest, end, 0.0);
  return (end - start.distance) - added;
}

}  // namespace microslip
