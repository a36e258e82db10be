// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "microslip/friction/traction_bound.hpp"

namespace microslip::experiments {

/// A foundation of springs, as in FASTSIM, under a constant creepage w: bristles that come without
/// a load at the leading edge, are stretched by w dq over their compliance, which is in proportion
/// to the half-width of the moment, and keep the bound.
struct Bristles {
  HertzBound bound;
  double creepage;    ///< w, not 0  [1]
  double compliance;  ///< at the half-width of the bound  [mm^3/N]

  /// dF/(mu dP) about the steady state, where the half-width goes with the root of P.
  /// \param wavelength  L  [mm]
  std::complex<double> force_by_normal_load(double wavelength) const;
};

/// The same in steps of a bristle. The error is of first order in their distance.
class BristleContact {
 public:
  /// \param number  of bristles over the half-width of the bound, >= 1
  BristleContact(const Bristles& bristles, int number);

  /// Rolls by one bristle.
  /// \param size  of half-width and bound at the end, over those of the bound, in [0, 2]
  void roll(double size);

  double step() const { return step_; }    ///< from bristle to bristle  [mm]
  double force() const { return force_; }  ///< [N/mm]

 private:
  Bristles bristles_;
  double step_;
  double force_ = 0;
  std::vector<double> traction_;  ///< from twice the half-width behind the centre to as far ahead
};

}  // namespace microslip::experiments
