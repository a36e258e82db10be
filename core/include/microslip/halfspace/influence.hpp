// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/linalg/linear_operator.hpp"
#include "microslip/linalg/solver.hpp"
#include "microslip/linalg/toeplitz.hpp"

namespace microslip {

/// \file
/// Influence coefficients: the displacement [mm] that a shape function of unit size [N/mm^2]
/// causes  [mm^3/N]. Lengths named `offset` and `shift` are in units of the spacing dx, so
/// that grid distances are exact integers.
///
/// Both are single integrals of the kernel's decay, which is positive, against a piecewise
/// polynomial weight that is formed without cancellation. Gauss-Legendre panels graded towards the
/// kernel's singularities make them accurate to rounding at any distance, shift and strip width.
///
/// A layer's compliance C adds C times the traction at the same place. Constant functions stand for
/// tractions that are linear between the nodes there, as the layer would else feel jumps: A - A'
/// would vanish for shifts below half an element.
/// \throws std::invalid_argument for a SymbolKernel with wave numbers above 1000/dx, which would
///         take minutes

/// A(offset): displacement at a distance `offset` dx from the node.
/// \param spacing  dx, in (0, inf)  [mm]
/// \return         thesis (2.15), (6.10)  [mm^3/N]
/// Accuracy: 2e-15 relative, for strips from 0.001 dx to 1e8 dx and plane strain, nu from 0 to 0.5,
/// offsets up to 1e6, tests/digits/influence_test.cpp
double influence(const Kernel& kernel, const ShapeFunction& shape, double spacing, double offset);

/// A(offset) - A(offset + shift), without the cancellation of the difference.
/// \param shift  upstream distance in units of dx, in (0, inf)
/// \return       thesis (A.4)-(A.6)  [mm^3/N]
/// Accuracy: 2e-13 relative, and 2e-15 in plane strain, for strips, nu and offsets likewise, shifts
/// from 1e-15 to 1000. Where the entry vanishes, for offset 0 as shift^2 and elsewhere by symmetry,
/// the accuracy is relative to the largest entry of its row. tests/digits/influence_test.cpp
double influence_difference(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                            double offset, double shift);

/// Below this a step is lost in the rounding of a position.
inline constexpr double min_step_ratio = 1e-15;

/// Whether elements are short enough for the waves of a kernel's table, as influence() wants them.
bool resolves_waves(const Kernel& kernel, double spacing);

/// \param name  of the argument, for the message
/// \throws std::invalid_argument unless the ratio is in [min_step_ratio, inf)
void require_step_ratio(double step_ratio, std::string_view name = "step_ratio");

/// Whether a step is at most as long as that of under-relaxation, c <= c*, but for the rounding of
/// quotients of lengths.
bool is_within_relaxation(double step_ratio, double relaxation);

/// A for n equal functions on a uniform grid: A_ij = A(i - j).
Toeplitz influence_toeplitz(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                            Eigen::Index n);

/// A - A' of the same, A' taken a distance `step_ratio` dx upstream: thesis (3.5).
/// \throws std::invalid_argument if step_ratio is not in [min_step_ratio, inf)
Toeplitz influence_difference_toeplitz(const Kernel& kernel, const ShapeFunction& shape,
                                       double spacing, Eigen::Index n, double step_ratio);

/// A for the functions of a basis: displacement at node i by the function of node j. n^2 numbers.
Eigen::MatrixXd influence_matrix(const Kernel& kernel, const Basis& basis, double spacing,
                                 Eigen::Index n);

/// A - A' for the functions of a basis.
/// \throws std::invalid_argument if step_ratio is not in [min_step_ratio, inf)
Eigen::MatrixXd influence_difference_matrix(const Kernel& kernel, const Basis& basis,
                                            double spacing, Eigen::Index n, double step_ratio);

/// Whether the solver takes FFT for these coefficients; all functions must be equal.
/// \throws std::invalid_argument if the solver demands FFT and functions differ
bool by_fft(const Solver& solver, const Basis& basis, Eigen::Index n);

// Coefficients arranged for a solver: Toeplitz if by_fft(), else all entries.
// \throws std::invalid_argument as by_fft(), or if n is too large for all entries

LinearOperator influence_operator(const Kernel& kernel, const Basis& basis, double spacing,
                                  Eigen::Index n, const Solver& solver);

LinearOperator influence_difference_operator(const Kernel& kernel, const Basis& basis,
                                             double spacing, Eigen::Index n, double step_ratio,
                                             const Solver& solver);

/// The solver for strain_operator. For c -> 0 the operator turns antisymmetric, and so singular for
/// an odd number of elements in adhesion. Below c = 0.01 an automatic solver becomes dense, because
/// LU with pivots keeps more digits than GMRES.
Solver strain_solver(const Solver& wanted, Eigen::Index n, double step_ratio);

/// (A - A')/dq, the negative of the strain by differences over dq  [mm^2/N].
LinearOperator strain_operator(const Kernel& kernel, const Basis& basis, double spacing,
                               Eigen::Index n, double step_ratio, const Solver& solver);

}  // namespace microslip
