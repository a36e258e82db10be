// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/reference/cattaneo.hpp"

namespace microslip {

/// Mindlin's exact solution of a force that oscillates between -+F* without rolling: plane strain,
/// Hertzian bound. Under F* it is Cattaneo's solution. On the way back the bodies slip in the other
/// direction, and the change of the traction is bounded by twice the bound (Masing's rule):
/// tractions and shift are Cattaneo's under F* minus twice Cattaneo's under (F* - F)/2. The way
/// forth is the mirror image of the way back. With tau = |F*| over full sliding, F_s, a cycle loses
/// \f[ D = k F_s^2\,\big(2(1-\tau)\ln(1-\tau)+2\tau-\tau^2\big) = k F_s^2\,\big(\tau^3/3+\tau^4/6
///    +\dots\big),\qquad k=\frac{2(1-\nu)}{\pi G}, \f]
/// for any L0. Source: K. L. Johnson, Contact Mechanics, 1985, section 7.4, in two dimensions.
/// Accuracy: as Cattaneo at F* and at (F* - F)/2; of the dissipation, 1e-14 relative for any force.
/// tests/unit/fretting_cycle_test.cpp
class FrettingCycle {
 public:
  /// \param force  F*, where the way back begins; at most full sliding in absolute value  [N/mm]
  /// \throws std::invalid_argument above full sliding
  FrettingCycle(const Material& material, const HertzBound& bound, double force);

  /// p(x) on the way back; zero outside the contact  [N/mm^2]
  /// \param force  F now, from F* to -F*  [N/mm]
  /// \throws std::invalid_argument outside the range
  double traction(double x, double force) const;

  /// Rigid shift on the way back; at the ends of the way its sign is opposite to F  [mm]
  /// \param force   as for traction()
  /// \param length  L0 of the plane kernel, in (0, inf)  [mm]
  double shift(double force, double length) const;

  /// D of a whole cycle, per mm of width  [N]
  double dissipation() const;

 private:
  Cattaneo change(double force) const;

  Material material_;
  HertzBound bound_;
  double end_;  ///< F*
  Cattaneo at_end_;
};

}  // namespace microslip
