// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// \file
/// Answers to a small step in plane strain, about steady rolling with one stick zone of the
/// half-length l; at rest, and under small loads, l is the half-width. They are inverse Laplace
/// transforms with the modified Bessel functions I0, I1. The integral along the imaginary axis is
/// taken to where their asymptotic series hold. From there on each power of exp(-2 s), a delay by
/// the length of the stick zone, is integrated along the line on which it decays.
/// Accuracy: 1e-10, tests/unit/small_motion_test.cpp. Cost: 1e3 to 1e5 Bessel functions.

/// The force after a step of the creepage by dw is \f$ -\frac{l}{k}\,dw\,S(q/l) \f$, and that of a
/// transient after a first step of any length has the slope \f$-\frac lk S\f$ in the creepage.
/// \f[ S = \mathcal L^{-1}\frac1{s\,(I_0/(I_0+I_1) + \lambda s)} \f]
/// \param distance  rolled, over l, in [1e-3, 1e3]  [1]
/// \param lambda    ln(2 L0/l), in [0.2, 100]  [1]
/// \return          from 0 to about 1; it overshoots
/// \throws std::invalid_argument outside the ranges
double force_after_creepage_step(double distance, double lambda);

/// The creepage after a step of the force, from rest, over the steady one. It does not know L0,
/// begins with 1/2, and is singular like a logarithm at the distance 2, where the peak that was
/// laid down at the leading edge leaves the contact,
///
/// \f[ c = \mathcal L^{-1}\frac{I_0}{s\,(I_0+I_1)} \f]
///
/// \param distance  rolled, over l, in [1e-3, 1e3]; infinite at 2  [1]
///
/// \throws std::invalid_argument outside the range
double creepage_after_force_step(double distance);

}  // namespace microslip
