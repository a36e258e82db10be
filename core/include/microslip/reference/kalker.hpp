// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace microslip {

/// Forces and moment of a contact ellipse that sticks everywhere, with c^2 = a b:
///   F_x = -G c^2 C11 xi,  F_y = -G c^2 C22 eta - G c^3 C23 phi,
///   M_z = G c^3 C32 eta - G c^4 C33 phi.
/// By reciprocity C32 is C23.
struct CreepCoefficients {
  double c11, c22, c23, c32, c33;

  /// In this order.
  std::array<double, 5> values() const { return {c11, c22, c23, c32, c33}; }
  static CreepCoefficients of(const std::array<double, 5>& values) {
    return {values[0], values[1], values[2], values[3], values[4]};
  }
};

/// Coefficients, and how far each of them may be off.
struct EstimatedCreepCoefficients {
  CreepCoefficients value;
  /// The larger change from an odd and an even order, both two thirds of this one; of C23 and C32
  /// at least their difference. The limit was never further off: tests/unit/kalker_test.cpp
  CreepCoefficients error;
};

/// The ratios a/b for which creep_coefficients() has them.
inline constexpr double least_kalker_ratio = 0.01, largest_kalker_ratio = 100;

/// Kalker's coefficients of steady rolling, by Galin's theorem: a polynomial over
/// sqrt(1 - x^2/a^2 - y^2/b^2) displaces the surface by a polynomial of the same degree. Each
/// degree has its own small equations. The degrees are coupled by the leading edge alone, on which
/// tractions vanish. Nothing is shared with joined rows. Derivation: docs/ellipse.md.
/// Accuracy: the default order has relative errors below 1e-8 for a/b >= 1, below 1e-6 for
/// a/b >= 0.2, and below 5e-6 for a/b >= 0.05; errors of C11 and C22 are below 1e-7 there. Without
/// Poisson's ratio any order is exact. The error falls by a factor of about 20 as the order
/// doubles: tests/unit/kalker_test.cpp. Cost: about 10 ms.
/// \param ratio          a/b in [0.01, 100], a along the rolling
/// \param poisson_ratio  nu in [0, 0.5]
/// \param order          largest degree of the polynomials, 12 ... 96
/// \throws std::invalid_argument outside the ranges
EstimatedCreepCoefficients creep_coefficients(double ratio, double poisson_ratio,
                                              Eigen::Index order = 48);

}  // namespace microslip
