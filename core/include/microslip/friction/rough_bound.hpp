// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/traction_bound.hpp"

namespace microslip {

/// A self-affine profile. Its power spectrum falls with the wave number to the power -(1 + 2 H).
struct Roughness {
  double amplitude;   ///< root of the mean square, relative to the smooth bound, [0, 10]  [1]
  double hurst;       ///< Hurst exponent H in (0, 1]: the smaller, the rougher  [1]
  unsigned seed = 1;  ///< of the phases
  Eigen::Index rows = 2049;  ///< of the table, [9, 1000001]; waves down to two rows
};

/// Hertz's bound times 1 + r, where r is the self-affine profile; zero where that would be
/// negative. The waves of r have the lengths 2a/k, k = 1, 2, ..., and phases by std::mt19937_64, so
/// that a seed gives the same table everywhere, to rounding. More rows add shorter waves and leave
/// the phases of the others as they are.
/// \throws std::invalid_argument outside the ranges, and for a bound that is zero everywhere
TabulatedBound rough_bound(const HertzBound& smooth, const Roughness& roughness);

}  // namespace microslip
