// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

/// A fraction of an element below this limit counts as zero, because distances are sums with
/// rounding errors.
inline constexpr double substep_rounding = 1e-9;

/// The distance that a contact has rolled over the elements of its material.
struct ElementTravel {
  double distance = 0;        ///< rolled  [mm]
  double distance_error = 0;  ///< rounding error in `distance`  [mm]
  double origin = 0;          ///< distance from which elements are counted  [mm]
  double entered = 0;         ///< whole elements travelled since the origin

  /// The fraction of an element travelled since the last whole element. The spacing is the distance
  /// of the nodes, dx [mm]
  double phase(double spacing) const { return (distance - origin) / spacing - entered; }

  /// Replaces the distance by an equal one with fewer rounding errors.
  void move_to(double at) {
    distance = at;
    distance_error = 0;
  }
};

/// Divides a step into substeps. Each of them ends where an element has been travelled, or at the
/// end of the step. Sums of distances are compensated; otherwise steps of whole elements would be
/// divided after about ten thousand steps.
/// \param start    at the beginning of the step
/// \param length   of the step  [mm]
/// \param spacing  dx  [mm]
/// \param substep  called for each substep with the substep's length, the distance at its end,
///                 and the remaining length of the step  [mm]
/// \return         the distance_error at the end of the step  [mm]
/// \throws std::invalid_argument if the length is below min_step_ratio dx
template <class Substep>
double for_each_element(const ElementTravel& start, double length, double spacing,
                        const Substep& substep) {
  require_step_ratio(length / spacing);
  const double added = length - start.distance_error;
  const double end = start.distance + added;
  double from = start.distance;
  double rest = length;
  for (double next = start.entered + 1; (end - start.origin) / spacing - next > substep_rounding;
       ++next) {
    const double to = start.origin + next * spacing;
    rest -= to - from;
    substep(to - from, to, rest);
    from = to;
  }
  substep(rest, end, 0.0);
  return (end - start.distance) - added;
}

}  // namespace microslip
