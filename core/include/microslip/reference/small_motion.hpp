// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// \file
/// Responses to a small step in plane strain, about steady rolling with one stick zone of the
/// half-length l; at rest, and under small loads, l is the half-width. The responses are inverse
/// Laplace transforms with the modified Bessel functions I0, I1. The integral runs along the
/// imaginary axis up to the point where the asymptotic series of the Bessel functions hold. Beyond
/// that point each power of exp(-2 sigma), a delay by the length of the stick zone, is integrated
/// along the line on which it decays. Accuracy: 1e-10, tests/unit/small_motion_test.cpp. Cost: 1e3
/// to 1e5 Bessel functions.

/// chi_F in the force after a step of the creepage by dw, \f$ -\frac{\ell}{k}\,dw\,\chi_F(q/\ell)
/// \f$. After the first step of a transient, of any length, the force has the slope
/// \f$-\frac\ell k \chi_F\f$ in the creepage.
/// \f[ \chi_F = \mathcal L^{-1}\frac1{\sigma\,(I_0/(I_0+I_1) + \lambda\sigma)} \f]
/// \param distance  rolled, over l, in [1e-3, 1e3]  [1]
/// \param lambda    ln(2 L0/l), in [0.2, 100]  [1]
/// \return          chi_F, from 0 to slightly above 1
/// \throws std::invalid_argument outside the ranges
double force_after_creepage_step(double distance, double lambda);

/// The creepage after a step of the force from rest, over the steady creepage. It does not depend
/// on L0 and begins with 1/2. It has a logarithmic singularity at the distance 2, where the
/// traction peak that formed at the leading edge leaves the contact,
///
/// \f[ \chi_w = \mathcal L^{-1}\frac{I_0}{\sigma\,(I_0+I_1)} \f]
///
/// \param distance  rolled, over l, in [1e-3, 1e3]; infinite at 2  [1]
///
/// \throws std::invalid_argument outside the range
double creepage_after_force_step(double distance);

}  // namespace microslip
