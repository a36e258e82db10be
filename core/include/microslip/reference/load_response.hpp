// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

namespace microslip {

/// Response of the force to a small oscillation of the normal load, dF/(mu dP), about Carter's
/// solution under a constant positive creepage. Plane strain; the half-width of the Hertzian
/// contact goes with the square root of the load. With the half-length \f$\ell=a'a\f$ of the stick
/// zone, \f$Q=J_0/(J_0+iJ_1)\f$ of \f$\kappa\ell\f$ and \f$H=1/(Q+i\kappa\ell\ln(2L_0/\ell))\f$,
/// \f[ \frac{dF}{\mu\,dP} = -\Big(1-H\,\big(a'Q+i\kappa\ell\ln(2L_0/a)\big)\Big) \f]
///
/// \param wave         kappa a, 2 pi a over the wavelength, in (0, 1e4]  [1]
/// \param stick_ratio  a', in (0, 1]
/// \param length       L0/a, in (1/2, inf)  [1]
/// \throws std::invalid_argument outside the ranges
/// Accuracy: 1e-10, tests/unit/load_response_test.cpp
std::complex<double> force_by_normal_load(double wave, double stick_ratio, double length);

}  // namespace microslip
