// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace microslip {

/// Half-width and bound of a contact, over the problem's. For a Hertzian contact under P
/// instead of P_0 both are sqrt(P/P_0), and of bodies that touch in a point (P/P_0)^(1/3); another
/// friction coefficient changes the bound alone.
struct ContactScale {
  double half_width = 1;  ///< a, >= 0
  double bound = 1;       ///< g at the same x/a, >= 0

  bool operator==(const ContactScale&) const = default;

  /// The force of full sliding of a line contact, over the problem's.
  double full_sliding() const { return half_width * bound; }

  /// Whether there can be tractions; otherwise the bodies do not touch, or slide without friction.
  bool carries() const { return half_width > 0 && bound > 0; }
};

/// The contact on the way from one contact to another; half-width and bound are linear on the way.
/// \param part  fraction of the way, in [0, 1]
ContactScale between(const ContactScale& from, const ContactScale& to, double part);

/// The Hertzian contact under another normal load.
/// \param load_ratio      P/P_0, >= 0
/// \param friction_ratio  mu/mu_0, >= 0
/// \throws std::invalid_argument outside the ranges
ContactScale hertz_scale(double load_ratio, double friction_ratio = 1);

/// The same of bodies that touch in a point, whose contact is an ellipse: both half-widths and the
/// peak are as the cube root of the load (Johnson, Contact Mechanics, section 4.2).
/// \throws std::invalid_argument outside the ranges
ContactScale hertz_point_scale(double load_ratio, double friction_ratio = 1);

/// \param full_sliding  of the problem's contact  [N/mm]
/// \param name          of the force, for the message
/// \throws std::invalid_argument unless the force is below full sliding of the contact; 0 where it
///                               carries nothing
void require_carried(double force, const ContactScale& contact, double full_sliding,
                     std::string_view name = "force");

}  // namespace microslip
