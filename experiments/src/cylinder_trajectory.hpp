// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/dynamics/cylinder.hpp"

namespace microslip::experiments {

/// The motion of a cylinder at given times.
struct Trajectory {
  Eigen::ArrayX3d values;  ///< position [mm], velocity [mm/s], angular velocity [1/s]
  double steps;            ///< made
  double contact_steps;    ///< solved
};

/// Rolls a cylinder, and interpolates its motion by the cubics that fit values and rates at the
/// ends of each step: the error is of fourth order.
/// \param cylinder  that rolls
/// \param times     ascending, > 0  [s]
Trajectory trajectory(RollingCylinder body, const Cylinder& cylinder, const Eigen::VectorXd& times);

/// Returns the root of the mean square of each of the three errors, over the value at the end.
Eigen::Array3d errors_of(const Trajectory& coarse, const Trajectory& fine);

}  // namespace microslip::experiments
