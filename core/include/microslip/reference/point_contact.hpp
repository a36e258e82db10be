// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "microslip/halfspace/material.hpp"

namespace microslip {

/// The sum of the curvatures of two bodies in one plane, where they touch.
/// \param radius_1, radius_2  negative for a concave body, and 0 for a flat one; otherwise from 1e-50
///                            to 1e50 in size  [mm]
/// \param name_1, name_2      of the radii, for messages
/// \return a number > 0  [1/mm]
/// \throws BadParameter of the radius that is wrong, if the sum is not above 0
double summed_curvature(std::string_view name_1, double radius_1, std::string_view name_2,
                        double radius_2);

/// Hertz's point contact of two like bodies, with their principal curvatures along and across the
/// rolling. With E* = G/(1 - nu), the larger and the smaller semi-axis l and s, k = s/l, the relative
/// curvatures A_l and A_s in their directions and Carlson's integral R_D,
/// \f[ \frac{A_s}{A_l} = \frac{R_D(0,1,k^2)}{R_D(0,k^2,1)},\qquad
///     l^3 = \frac{P}{\pi E^* A_l}\,R_D(0,k^2,1),\qquad p_0 = \frac{3P}{2\pi ls} . \f]
/// Source: K. L. Johnson, Contact Mechanics, 1985, section 4.2(b).
/// Accuracy: 1e-12 relative, for ratios of curvatures to 1e8: tests/unit/point_contact_test.cpp
class PointContact {
 public:
  /// \param load    P in (0, inf)  [N]
  /// \param along   sum of both bodies' curvatures in the plane of rolling, in (0, inf)  [1/mm]
  /// \param across  the same across the rolling  [1/mm]
  /// \throws std::invalid_argument outside the ranges, or if one curvature is above 1e8 times the
  ///         other
  PointContact(const Material& material, double load, double along, double across);

  double half_width() const { return half_width_; }                  ///< a  [mm]
  double lateral_half_width() const { return lateral_half_width_; }  ///< b  [mm]
  double peak_pressure() const { return peak_; }                     ///< p_0  [N/mm^2]

 private:
  double half_width_, lateral_half_width_, peak_;
};

}  // namespace microslip
