// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "microslip/friction/traction_bound.hpp"

namespace microslip::experiments {

/// A foundation of springs, as in FASTSIM, under a constant creepage w. Bristles enter unloaded at
/// the leading edge. Each step dq raises their traction by w dq over their compliance, up to the
/// bound. The compliance is proportional to the current half-width.
struct Bristles {
  HertzBound bound;
  double creepage;    ///< w, not 0  [1]
  double compliance;  ///< at the half-width of the bound  [mm^3/N]

  /// dF/(mu dP) about the steady state; the half-width is proportional to the square root of P.
  /// \param wavelength  L  [mm]
  std::complex<double> force_by_normal_load(double wavelength) const;
};

/// The spring foundation, rolled in steps of one bristle. The error is of first order in the
/// distance of bristles.
class BristleContact {
 public:
  /// \param number  of bristles over the half-width of the bound, >= 1
  BristleContact(const Bristles& bristles, int number);

  /// Rolls by one bristle.
  /// \param size  scale of half-width and bound at the end of the step, over the initial ones, in
  ///              [0, 2]
  void roll(double size);

  double step() const { return step_; }    ///< from bristle to bristle  [mm]
  double force() const { return force_; }  ///< [N/mm]

 private:
  Bristles bristles_;
  double step_;
  double force_ = 0;
  std::vector<double> traction_;  ///< from two half-widths behind the centre to two ahead
};

}  // namespace microslip::experiments
