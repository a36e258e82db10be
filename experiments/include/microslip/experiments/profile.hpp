// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip::experiments {

/// \file
/// The shape of values at uniform nodes. Positions count nodes from 0.

/// Number of interior local extrema; equal neighbours do not count.
/// \param threshold  rises and falls up to this are flat, >= 0
Eigen::Index turning_points(const Eigen::VectorXd& values, double threshold = 0);

/// Sum of all rises and falls between neighbours.
double total_variation(const Eigen::VectorXd& values);

/// A maximum between nodes.
struct Peak {
  double height;    ///< of the largest value
  double position;  ///< of the top of the parabola through the largest value and its neighbours
  double width;     ///< distance of the nearest points at half the height on both sides
};

/// The largest value; the width ends at the first and last node at the latest.
Peak peak_of(const Eigen::VectorXd& values);

}  // namespace microslip::experiments
