// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/joined_rows.hpp"

namespace microslip {

/// Response of a patch that sticks everywhere to a small oscillating motion m exp(i kappa q), over
/// the distance q that it rolls: Kalker's coefficients as complex functions of the wave number.
///
/// A displacement u exp(i kappa q) of material that sticks obeys w + i kappa u - du/dx = 0 with the
/// rigid slip w = (xi - phi y, eta + phi x). Along a row, with its leading edge at e,
///   u(x) = u(e) exp(i kappa (x - e)) - integral of w(x') exp(i kappa (x - x')) dx' from x to e.
/// This is taken at the centres of cells, and the unknowns v of JoinedRows follow from it. Without
/// interpolation in x the relation is exact; u(e) is by the tractions, which vanish there. So the
/// displacements of centres are inverted once, and a wave number costs a system of two unknowns a
/// row.
///
/// As kappa tends to 0, these are the equations of PatchResponse::linear(). Units and signs are
/// those of PatchResponse.
/// Order: 2 in 1/N where M/N is kept. Errors are below 2e-3 of the steady coefficients with 12 rows
/// of 20 cells for wavelengths from 2.5 half-lengths on, on a circle; tests/unit/patch_frequency_test.cpp
/// Cost: O((M N)^3) once, O(M^2 N + M^3) per wave number.
class PatchFrequencyResponse {
 public:
  /// \param poisson_ratio  nu, in [0, 0.5]
  PatchFrequencyResponse(const JoinedRows& rows, double poisson_ratio);

  const JoinedRows& rows() const { return rows_; }

  /// Resultants by the motion: -C11, -C22, -C23, C32 and -C33, with phases.
  /// \param wave_number  kappa = 2 pi/wavelength, times the size of the patch, in [0, 1e3]
  /// \throws std::invalid_argument outside the range
  Eigen::Matrix3cd linear(double wave_number) const;

  /// The unknowns v by the motion: 2n x 3.
  Eigen::MatrixX3cd unknowns(double wave_number) const;

 private:
  /// The displacements of the centres by the motion: real parts, then imaginary ones, 2n x 6.
  Eigen::MatrixXd displacements(double wave_number) const;

  JoinedRows rows_;
  Eigen::MatrixXd inverse_;      ///< v by the displacements of centres: 2n x 2n
  Eigen::MatrixXd edges_;        ///< displacements of leading edges by those of centres: 2M x 2n
  Eigen::Matrix3Xd resultants_;  ///< by the displacements of centres: 3 x 2n
};

}  // namespace microslip
