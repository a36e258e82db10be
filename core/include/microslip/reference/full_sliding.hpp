// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// Forces and moment of Hertz's ellipse on which all slides, each traction against the rigid slip
/// (xi - phi y, eta + phi x). Only the direction of the motion counts. By quadrature along the rays
/// from the pole of the motion, on which the slip has one direction.
/// Accuracy: 1e-9, and 1e-6 where the pole is on the edge: tests/unit/full_sliding_test.cpp
/// \param ratio   a/b, > 0
/// \param motion  xi, eta [1] and phi c [1], c = (a b)^(1/2); not all 0
/// \return        Fx and Fy over mu F_n, and Mz over mu F_n c  [1]
/// \throws std::invalid_argument outside the ranges
Eigen::Vector3d full_sliding(double ratio, const Eigen::Vector3d& motion);

}  // namespace microslip
