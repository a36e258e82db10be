// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/linalg/lu_factors.hpp"

namespace microslip {

/// \file
/// Response of the force to a small harmonic creepage w = w0 + w1 exp(i kappa q) about steady
/// rolling with one stick zone [b, f]. Slip zones do not respond: their traction is the bound, and
/// their ends move by a length of the order of w1. In the stick zone the displacement u obeys
/// w1 + (i kappa - d/dx) u = 0. The traction that causes u is singular like an inverse square root
/// at b, and vanishes like a square root at f: docs/theory.md, "Small motions".

/// \f$ Q = J_0/(J_0 + i J_1) \f$ of plane strain, at \f$\kappa\ell\f$, where l is the half-length
/// of the stick zone and kappa the wave number, 2 pi over the wavelength.
/// \param kappa  times l, in [0, 1e6]; accuracy 1e-15 relative, besides the effect of rounding
///               kappa
std::complex<double> adhesion_ratio(double kappa);

/// dF/dw of a stick zone, for wavelengths 2 pi/kappa of the creepage.
///
/// Plane strain has a closed form,
/// \f[ \frac{dF}{dw} = -\frac{\ell}{k}\,\frac1{Q + i\kappa\ell\,\ln(2L_0/\ell)} . \f]
/// For strips the traction is \f$(1-\xi^2)^{-1/2}\sum_n \alpha_n T_n(\xi)\f$ on the zone. The
/// logarithm of the kernel is diagonal in these functions; its regular part is integrated by
/// Gauss-Chebyshev quadrature.
///
/// Accuracy: 1e-10 relative for strips of at least 0.05 stick lengths, 1e-14 in plane strain, from
/// the shortest wavelength on; tests/unit/frequency_response_test.cpp. Cost of strips: O(n^3) once,
/// with n = 70 for wide strips, plus 1.5 kappa l; O(n^2) per wavelength.
class FrequencyResponse {
 public:
  /// \param begin, end  b < f, ends of the stick zone  [mm]
  /// \param shortest    the shortest wavelength for slope()  [mm]
  /// \throws BadParameter unless the kernel is positive definite on the zone, and if the strip is
  ///                      too narrow, or the wavelength too short, for 700 terms
  FrequencyResponse(const Kernel& kernel, double begin, double end, double shortest);

  double half_length() const { return half_length_; }  ///< of the stick zone  [mm]

  /// \param wavelength  2 pi/kappa, finite, at least the shortest  [mm]
  /// \return            dF/dw  [N/mm]
  /// \throws BadParameter outside the range
  std::complex<double> slope(double wavelength) const;

  /// dF/dw of an infinite wavelength: the slope of the steady creepage-force curve  [N/mm]
  double steady_slope() const;

  /// An estimate of the relative error of slope(); for strips, the difference to the solution with
  /// a fifth fewer terms.
  double estimated_error(double wavelength) const;

  Eigen::Index terms() const;  ///< n for a strip; 0 in plane strain

 private:
  /// Turns displacements of the zone, given at Chebyshev points, into tractions.
  struct Series {
    Eigen::ArrayXd points;  ///< xi, in (-1, 1)
    /// LU factors of the displacements due to unit coefficients alpha_n, over the zone's
    /// half-length and k.
    LuFactors factors;
    Eigen::MatrixXd to_coefficients;

    Series(const Kernel& kernel, double half_length, Eigen::Index terms);
    std::complex<double> slope(double half_length, double wave_number) const;
  };

  std::complex<double> slope_of_wave(double wave_number) const;

  Kernel kernel_;
  double half_length_;
  double shortest_;
  std::vector<Series> series_;  ///< of a strip: with a fifth fewer terms, and with all
};

}  // namespace microslip
