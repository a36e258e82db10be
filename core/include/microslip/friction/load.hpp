// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <variant>

namespace microslip {

/// Prescribes the creepage of rolling bodies; the force follows. A positive creepage gives negative
/// tractions, and so does a positive shift.
struct PrescribedCreepage {
  double value;  ///< relative rigid slip w, finite  [1]
};

/// Prescribes a rigid shift of one body along the other; the force follows.
struct PrescribedShift {
  double value;  ///< finite  [mm]
};

/// Prescribes the force, the resultant of the tractions; the creepage or the shift follows.
struct PrescribedForce {
  double value;  ///< F, less in absolute value than full sliding  [N/mm]
};

/// The load of bodies that roll.
using Load = std::variant<PrescribedCreepage, PrescribedForce>;

/// The load of a shift without rolling, or of a step as a whole: its shift is creepage times
/// length.
using ShiftLoad = std::variant<PrescribedShift, PrescribedForce>;

/// A load of either kind as the slip conditions take it: the force, or the rigid slip in the unit
/// of the slip, which is a creepage [1] or a shift [mm].
struct Prescribed {
  bool by_force;
  double value;

  Prescribed(PrescribedCreepage creepage) : by_force(false), value(creepage.value) {}  // NOLINT
  Prescribed(PrescribedShift shift) : by_force(false), value(shift.value) {}           // NOLINT
  Prescribed(PrescribedForce force) : by_force(true), value(force.value) {}            // NOLINT
  template <class... Loads>
  Prescribed(const std::variant<Loads...>& load)  // NOLINT: every load is prescribed
      : Prescribed(std::visit([](const auto& of) { return Prescribed(of); }, load)) {}

  bool operator==(const Prescribed&) const = default;

  /// The sign of the rigid slip: a positive one gives a negative force. 0 without a load.
  double direction() const {
    if (value == 0) return 0;
    return (value < 0) == by_force ? 1 : -1;
  }
};

/// The load of a step as a whole.
/// \param length  length of the step  [mm]
ShiftLoad over_length(const Load& load, double length);

/// \param full_sliding  the largest force that the bound allows  [N/mm]
/// \param name          of the force, for the message
/// \throws std::invalid_argument unless the force is below full sliding in absolute value
void require_below_full_sliding(double force, double full_sliding, std::string_view name = "force");

/// The same for a load; a creepage or shift has to be finite.
void require_below_full_sliding(const Prescribed& load, double full_sliding);

}  // namespace microslip
