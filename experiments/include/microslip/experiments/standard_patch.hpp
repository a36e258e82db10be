// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip::experiments {

/// Resultants of an ellipse with a b = 1 on which all sticks, by the scheme that CONTACT has: equal
/// rectangles whose centres lie in the ellipse, with constant tractions; s = w + [u(x) - u(x +
/// dx)]/dx at the centres, and the rigid slip by spin at x + dx/6.
struct StandardPatch {
  Eigen::Index cells;      ///< number of rectangles
  Eigen::Matrix3d linear;  ///< as PatchResponse::linear()
};

/// \param ratio         a/b
/// \param elements      N, along the longest row and across
/// \param poisson_ratio  nu
/// Cost: (2 cells)^3.
StandardPatch standard_patch(double ratio, Eigen::Index elements, double poisson_ratio);

}  // namespace microslip::experiments
