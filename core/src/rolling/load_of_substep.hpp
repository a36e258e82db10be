// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <variant>

#include "microslip/friction/load.hpp"

namespace microslip {

/// The load of a part of a way: its part of the shift, or the force at its end. The force changes
/// linearly on the way.
/// \param before  the force at the beginning of the part  [N/mm]
/// \param part    fraction of the way that the part covers
/// \param end     fraction of the way at the end of the part
inline ShiftLoad load_of_part(const ShiftLoad& load, double before, double part, double end) {
  if (const auto* force = std::get_if<PrescribedForce>(&load)) {
    return PrescribedForce{std::lerp(before, force->value, end)};
  }
  return PrescribedShift{std::get<PrescribedShift>(load).value * part};
}

/// Derivatives of this load by creepage or force, and by length of the step. A longer step has a
/// longer last substep; at the end of an earlier substep, its force has changed by a smaller
/// fraction.
/// \param substep  length of the substep  [mm]
/// \param length   of the step  [mm]
inline std::array<ShiftLoad, 2> slopes_of_part(const ShiftLoad& load, double before, double substep,
                                               double end, double length, bool is_last) {
  if (const auto* force = std::get_if<PrescribedForce>(&load)) {
    const double by_length = is_last ? 0 : -(force->value - before) * end / length;
    return {PrescribedForce{end}, PrescribedForce{by_length}};
  }
  const double creepage = std::get<PrescribedShift>(load).value / length;
  return {PrescribedShift{substep}, PrescribedShift{is_last ? creepage : 0}};
}

}  // namespace microslip
