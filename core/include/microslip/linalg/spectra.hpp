// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// \file
/// Spectra of dense matrices for analysis and tests, by GSL. All take O(n^3) operations and leave the
/// matrix as it is; the matrix has at least one row.

/// Returns the n eigenvalues of a square matrix by imaginary part, and those of one by real part.
/// \throws NotConverged if the QR method ends without them
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Returns the least eigenvalue of a symmetric matrix; reads its lower triangle only.
/// \throws NotConverged if the QR method ends without it
double least_eigenvalue(const Eigen::MatrixXd& symmetric);

/// Returns the ratio of the largest singular value to the least: the condition number of the 2-norm.
/// It is infinite for a singular matrix.
/// \throws NotConverged if Jacobi's rotations end without them
double condition(const Eigen::MatrixXd& matrix);

}  // namespace microslip
