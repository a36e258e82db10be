// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// \file
/// These functions find spectra of dense matrices, by GSL. They serve analysis and tests. Each takes
/// O(n^3) operations. A matrix has at least one row.

/// Returns the n eigenvalues of a square matrix, sorted by imaginary part and then by real part.
/// \throws NotConverged if the QR method ends without them
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Returns the least eigenvalue of a symmetric matrix; reads its lower triangle only.
/// \throws NotConverged if the QR method ends without it
double least_eigenvalue(const Eigen::MatrixXd& symmetric);

/// Returns the ratio of the largest singular value to the least: the condition number of the 2-norm.
/// For a singular matrix it is infinite, or as large as rounding leaves it.
/// \param matrix  has at least as many rows as columns
/// \throws NotConverged if Jacobi's rotations end without them, or with fewer rows than columns
double condition(const Eigen::MatrixXd& matrix);

}  // namespace microslip
