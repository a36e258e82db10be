// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/linalg/toeplitz.hpp"

namespace microslip {

/// \file
/// The approximate inverse of a Toeplitz matrix by Fourier transformation, step by step:
/// thesis 6.3. It ignores the boundary. All vectors are of the matrix's size n.

/// Column through the middle of a matrix of size n, from 0. With n even, the next column is
/// unsuitable: its entries A(-n/2) - A(1 - n/2) + ... - A(n/2) add up to zero for c = 1, and step 4
/// divides by that sum.
Eigen::Index middle_index(Eigen::Index n);

/// Step 1: the column through the middle of the matrix.
Eigen::VectorXd middle_column(const Toeplitz& matrix);

/// Step 2: the entries above the diagonal go to the end, the diagonal to the front.
Eigen::VectorXd diagonal_first(const Eigen::VectorXd& column);

/// Step 3: discrete Fourier coefficients, sum of v_k exp(-2 pi i k m / n).
Eigen::VectorXcd fourier_coefficients(const Eigen::VectorXd& values);

/// Step 4. A coefficient of zero gives infinity.
Eigen::VectorXcd reciprocals(const Eigen::VectorXcd& coefficients);

/// Step 5: the inverse of step 3 for coefficients of a real vector.
Eigen::VectorXd inverse_transform(const Eigen::VectorXcd& coefficients);

/// Step 6: the inverse of step 2.
Eigen::VectorXd diagonal_in_the_middle(const Eigen::VectorXd& values);

/// Step 7: the Toeplitz matrix that has this middle column, and zeros where the column has no
/// entry.
Toeplitz toeplitz_from_middle_column(const Eigen::VectorXd& column);

/// The thesis keeps the zero frequency. For A - A' its coefficient vanishes on an unbounded grid,
/// and on a bounded one is a remainder of order 1/n, the reciprocal of which is a constant that
/// does not belong to the inverse.
enum class ZeroFrequency { keep, drop };

/// Steps 1 to 6: the middle column of the approximate inverse.
/// Accuracy: 1e-15 of its largest entry times the ratio of the largest to the least coefficient of
/// step 3, by which a rounding of the matrix is amplified. tests/digits/spectrum_test.cpp
Eigen::VectorXd approximate_inverse_column(const Toeplitz& matrix,
                                           ZeroFrequency zero_frequency = ZeroFrequency::keep);

}  // namespace microslip
