// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/load_response.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

std::complex<double> force_by_normal_load(double wave, double stick_ratio, double length) {
  require(wave > 0 && wave <= 1e4, "wave", wave, "a number > 0, <= 1e4");
  require(stick_ratio > 0 && stick_ratio <= 1, "stick ratio", stick_ratio, "a number > 0, <= 1");
  require(length > 0.5, "length", length, "a number > 0.5");
  const double kappa = wave * stick_ratio;
  const double j0 = gsl_sf_bessel_J0(kappa);
  const double j1 = gsl_sf_bessel_J1(kappa);
  // 1/Q is infinite where J0 is zero, so numerator and denominator are multiplied by J0.
  const std::complex<double> z = std::complex<double>(0, kappa) * std::complex<double>(j0, j1);
  const double whole = std::log(2 * length);
  const double stuck = std::log(2 * length / stick_ratio);
  return -(1.0 - (stick_ratio * j0 + z * whole) / (j0 + z * stuck));
}

}  // namespace microslip
