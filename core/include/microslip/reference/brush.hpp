// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"

namespace microslip {

/// Steady rolling of a brush, springs of one compliance C beside one another, under Hertz's bound:
/// tractions grow by |w|/C a length from the leading edge on, up to the bound. With m = |w| a over
/// C times the peak, the force and the stick-slip point b are
/// \f[ \frac{|F|}{F_{\max}} = \frac2\pi\Bigl(\frac m{1+m^2}+\arctan m\Bigr), \quad
///     \frac ba = \frac{m^2-1}{m^2+1} . \f]
/// Where something slips at any creepage; no creepage makes all slide. Under a parabola as the
/// bound the force is the cubic of Fastsim.
class Brush {
 public:
  /// \param compliance  C, in (0, inf)  [mm^3/N]
  /// \throws std::invalid_argument outside the range
  Brush(double compliance, const HertzBound& bound);

  /// F, against the creepage  [N/mm]
  /// \param creepage  w, finite
  double force(double creepage) const;

  /// b, behind which the bodies slip  [mm]
  double stick_edge(double creepage) const;

  /// p(x), zero outside the contact  [N/mm^2]
  double traction(double x, double creepage) const;

 private:
  double growth(double creepage) const;

  double compliance_;
  HertzBound bound_;
};

}  // namespace microslip
