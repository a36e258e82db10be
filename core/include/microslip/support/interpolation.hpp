// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// The value at x of what is linear between known positions, and constant beyond them.
/// \param positions  ascending, at least one
/// \param values     as many
/// Cost: O(log n)
double interpolated(const Eigen::VectorXd& positions, const Eigen::VectorXd& values, double x);

/// The same at several places.
Eigen::VectorXd interpolated(const Eigen::VectorXd& positions, const Eigen::VectorXd& values,
                             const Eigen::VectorXd& x);

}  // namespace microslip
