// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

namespace microslip {

/// Response of the force to a small oscillation of the normal load, dF/(mu dP), about Carter's
/// solution under a constant positive creepage. Plane strain; the half-width of the Hertzian
/// contact goes with the square root of the load. With \f$Z=i\kappa\alpha/R(\kappa\alpha)\f$,
/// \f$R=J_0/(J_0+iJ_1)\f$,
/// \f[ \frac{dF}{\mu\,dP} = -\Big(1-\frac{\alpha+Z\ln(2L_0/a)}{1+Z\ln(2L_0/(\alpha a))}\Big) \f]
///
/// \param wave         kappa = 2 pi a / L, in (0, 1e4]  [1]
/// \param stick_ratio  alpha = a'/a, in (0, 1]
/// \param length       L0/a, in (1/2, inf)  [1]
/// \throws std::invalid_argument outside the ranges
/// Accuracy: 1e-10, tests/unit/load_response_test.cpp
std::complex<double> force_by_normal_load(double wave, double stick_ratio, double length);

}  // namespace microslip
