// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"

namespace microslip {

/// Cattaneo's exact solution of a tangential shift without rolling: plane strain, Hertzian bound.
/// The middle zone of half-width k a sticks; |p| = g(x) - k g(x / k). Source: K. L. Johnson,
/// Contact Mechanics, 1985, section 7.2, in two dimensions. Accuracy: as Carter. The error of a
/// displacement is relative to the force; where ln(2 L0/a) exceeds 1, to the force times that
/// logarithm. tests/digits/closed_form_test.cpp
class Cattaneo {
 public:
  /// \param force  F, at most full sliding in absolute value  [N/mm]
  /// \throws std::invalid_argument above full sliding
  Cattaneo(const Material& material, const HertzBound& bound, double force);

  /// k = sqrt(1 - |F| / full sliding), in [0, 1].
  double stick_ratio() const { return stick_ratio_; }

  /// p(x), of the sign of the force; zero outside the contact  [N/mm^2]
  double traction(double x) const;

  /// Displacement of the stick zone: minus the shift of the bodies  [mm]
  /// \param length  L0 of the plane kernel, in (0, inf)  [mm]
  double displacement(double length) const;

 private:
  double compliance_;
  HertzBound bound_;
  double force_ratio_;  ///< |F| over full sliding
  double held_ratio_;   ///< 1 - force_ratio_, which is k^2
  double stick_ratio_;
  double direction_;  ///< sign of the force
};

}  // namespace microslip
