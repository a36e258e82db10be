// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// Storage of influence coefficients, and with it the algorithms for products and solves.
struct Solver {
  enum class Type {
    automatic,  ///< `fft` from `crossover` elements on where matrices are Toeplitz, else `dense`
    dense,      ///< all entries: O(n^2) memory and products, O(n^3) factors
    fft         ///< Toeplitz matrices by FFT: O(n) memory, O(n log n) products and solves
  };

  Type type = Type::automatic;

  /// Required residual, relative to the largest term of the equations, in [1e-12, 1e-3]. Refinement
  /// aims at 1e-5 of this tolerance.
  double tolerance = 1e-10;

  /// Below this number of unknowns, dense solves are faster than FFT: bench/toeplitz_bench.cpp
  static constexpr Eigen::Index crossover = 96;

  /// Largest number of rows of a dense matrix, which then takes 3.2 GB.
  static constexpr Eigen::Index most_dense = 20000;
};

/// Whether the solver uses FFT for Toeplitz matrices of n unknowns.
bool by_fft(const Solver& solver, Eigen::Index n);

/// \throws std::invalid_argument if a dense matrix of n rows would be too large
void require_dense(Eigen::Index n);

/// \throws std::invalid_argument if the tolerance or another limit is out of its range
void validate(const Solver& solver);

}  // namespace microslip
