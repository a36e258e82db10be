// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// Steady rolling of a strip by Kalker's simplified theory, as his program FASTSIM has it (Vehicle
/// System Dynamics 11, 1982, 1-13): the displacement is C times the traction at the same place, so
/// that a traction grows by |w|/C a length from the leading edge on, up to a parabola of the same
/// width and force as the bound. In two dimensions the sum of its slices has a closed form,
/// \f[ \frac{|F|}{F_{\max}} = 1 - \Bigl(1-\frac{|w|}{w_{\max}}\Bigr)^3, \quad
///     w_{\max} = \frac{3C\,F_{\max}}{2a^2}, \quad |w| \le w_{\max} . \f]
/// The flexibility C comes from Kalker's linear theory: without slip the force is 2 a^2 w/C, so
/// that C = 2 a^2/|dF/dw|. In plane strain that is 4 a (1 - nu)/(pi G).
class Fastsim {
 public:
  /// \param half_width  a, in (0, inf)  [mm]
  /// \param most        F_max, the force of full sliding, in (0, inf)  [N/mm]
  /// \param slope       |dF/dw| at w = 0, in (0, inf)  [N/mm]
  /// \throws std::invalid_argument outside the ranges
  Fastsim(double half_width, double most, double slope);

  double flexibility() const;  ///< C  [mm^3/N]

  /// The least creepage at which all slides, 3 F_max/|dF/dw|  [1]
  double full_sliding_creepage() const { return 3 * most_ / slope_; }

  /// F, against the creepage  [N/mm]
  /// \param creepage  w, finite
  double force(double creepage) const;

  /// p(x), zero outside the contact  [N/mm^2]
  double traction(double x, double creepage) const;

 private:
  double half_width_;
  double most_;
  double slope_;
};

}  // namespace microslip
