// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// How products with influence coefficients are made, and how their systems are solved.
struct Solver {
  enum class Type {
    automatic,  ///< `fft` from `crossover` elements on where matrices are Toeplitz, else `dense`
    dense,      ///< all entries: O(n^2) memory and products, O(n^3) factors
    fft         ///< Toeplitz matrices by FFT: O(n) memory, O(n log n) products and solves
  };

  Type type = Type::automatic;

  /// Residual that is wanted, relative to the largest term of the equations, in [1e-12, 1e-3].
  /// Refinement aims at 1e-5 of it.
  double tolerance = 1e-10;

  /// Dense systems of fewer unknowns are solved faster than by FFT, bench/toeplitz_bench.cpp
  static constexpr Eigen::Index crossover = 96;

  /// Dense matrices of more than this take more than 3.2 GB each.
  static constexpr Eigen::Index most_dense = 20000;
};

/// Whether the solver takes FFT for Toeplitz matrices of n unknowns.
bool by_fft(const Solver& solver, Eigen::Index n);

/// \throws std::invalid_argument if a dense matrix of n rows would be too large
void require_dense(Eigen::Index n);

/// \throws std::invalid_argument if the tolerance or another limit is out of its range
void validate(const Solver& solver);

}  // namespace microslip
