// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// The value at x by linear interpolation between positions; constant beyond the outermost ones.
/// \param positions  ascending, at least one
/// \param values     as many as positions
/// Cost: O(log n)
double interpolated(const Eigen::VectorXd& positions, const Eigen::VectorXd& values, double x);

/// The values at several places.
Eigen::VectorXd interpolated(const Eigen::VectorXd& positions, const Eigen::VectorXd& values,
                             const Eigen::VectorXd& x);

}  // namespace microslip
