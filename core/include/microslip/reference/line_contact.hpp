// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/material.hpp"

namespace microslip {

/// Hertz's line contact of two like cylinders with parallel axes. With the relative radius R_r,
/// 1/R_r = 1/R_1 + 1/R_2, the load P per width and E* = G/(1 - nu) = E/(2 (1 - nu^2)),
/// \f[ a^2 = \frac{4PR_r}{\pi E^*},\qquad p_0 = \frac{2P}{\pi a} . \f]
/// Source: K. L. Johnson, Contact Mechanics, 1985, section 4.2(c).
/// Accuracy: 2e-15 relative, besides the effect of rounding the curvature.
/// tests/unit/line_contact_test.cpp
class LineContact {
 public:
  /// \param load       P in (0, inf)  [N/mm]
  /// \param curvature  1/R_r in (0, inf)  [1/mm]
  /// \throws std::invalid_argument outside the ranges
  LineContact(const Material& material, double load, double curvature);

  double half_width() const { return half_width_; }  ///< a  [mm]
  double peak_pressure() const { return peak_; }     ///< p_0  [N/mm^2]

 private:
  double half_width_;
  double peak_;
};

}  // namespace microslip
