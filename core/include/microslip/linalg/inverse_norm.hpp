// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace microslip {

/// Estimate of the 1-norm of the inverse of an n x n matrix A: a lower limit, seldom below a third
/// of the norm (Hager 1984, Higham 1988). It takes about five solves.
/// \param solve             x := A^-1 x
/// \param solve_transposed  x := A^-T x
double inverse_norm(Eigen::Index n, const std::function<void(Eigen::VectorXd& x)>& solve,
                    const std::function<void(Eigen::VectorXd& x)>& solve_transposed);

}  // namespace microslip
