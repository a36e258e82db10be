// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <variant>

#include "microslip/friction/active_set.hpp"

namespace microslip {

/// The load of a substep in terms of slip displacement: the shift, or the force, which changes
/// linearly over the step.
/// \param before    the force at the beginning of the step  [N/mm]
/// \param substep   length of the substep  [mm]
/// \param fraction  fraction of the step at the end of the substep
inline Load load_within(const Load& load, double before, double substep, double fraction) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return load_of_step(load, substep);
  return PrescribedForce{std::lerp(before, force->value, fraction)};
}

/// Derivatives of a substep's load by load and length of the step. A longer step has a longer last
/// substep; at the end of an earlier substep, its force has changed by a smaller fraction.
/// \param length  of the step  [mm]
inline std::array<Load, 2> slopes_within(const Load& load, double before, double substep,
                                         double fraction, double length, bool is_last) {
  if (const auto* force = std::get_if<PrescribedForce>(&load)) {
    const double by_length = is_last ? 0 : -(force->value - before) * fraction / length;
    return {PrescribedForce{fraction}, PrescribedForce{by_length}};
  }
  const double creepage = std::get<PrescribedCreepage>(load).value;
  return {PrescribedCreepage{substep}, PrescribedCreepage{is_last ? creepage : 0}};
}

}  // namespace microslip
