// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// The size of a contact, over that of the problem. For Hertz's contact under P instead of P_0 both
/// are sqrt(P/P_0); another friction coefficient changes the bound alone.
struct ContactScale {
  double half_width = 1;  ///< a, >= 0
  double bound = 1;       ///< g at the same x/a, >= 0

  bool operator==(const ContactScale&) const = default;

  /// The force of full sliding, over that of the problem's contact.
  double full_sliding() const { return half_width * bound; }

  /// Without, the bodies do not touch, or slide without friction: no tractions.
  bool carries() const { return half_width > 0 && bound > 0; }
};

/// The contact on the way from one to another, half-width and bound being linear.
/// \param part  of the way, in [0, 1]
ContactScale between(const ContactScale& from, const ContactScale& to, double part);

/// The contact that Hertz's theory has under another normal load.
/// \param load_ratio      P/P_0, >= 0
/// \param friction_ratio  mu/mu_0, >= 0
/// \throws std::invalid_argument outside the ranges
ContactScale hertz_scale(double load_ratio, double friction_ratio = 1);

}  // namespace microslip
