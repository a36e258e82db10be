// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/rectangles.hpp"

namespace microslip {

/// Rectangles that touch, and the pressure in them.
struct RectanglePressure {
  Rectangles contact;
  Eigen::VectorXd pressure;  ///< at the elements, over Hertz's largest pressure  [1]
  double approach;           ///< of the bodies, over that by Hertz  [1]
  int iterations;
};

/// Solves the normal contact of paraboloids that touch in an ellipse after Hertz, on the rectangles
/// around it: pressures are constant in rectangles, gaps are those at their centres, and the force
/// is Hertz's. Some elements at the edge differ from those with centres in the ellipse.
/// Method: conjugate gradients with a projection (Polonsky and Keer 1999).
/// \param a,b       half-widths along and across the rolling, > 0
/// \param elements  N in the width 2 a, >= 1
/// \param rows      M in the width 2 b, >= 1
/// \throws std::invalid_argument outside the ranges; NotConverged
RectanglePressure pressure_of_rectangles(double a, double b, Eigen::Index elements,
                                         Eigen::Index rows);

}  // namespace microslip
