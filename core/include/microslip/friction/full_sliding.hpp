// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/chebyshev_field.hpp"

namespace microslip {

/// Strain and displacement of the half-space under the bound itself as traction, to rounding.
class FullSliding {
 public:
  /// \throws std::invalid_argument for a table, which is not smooth, and as ChebyshevField
  FullSliding(const Kernel& kernel, const TractionBound& bound);

  double force() const { return force_; }  ///< [N/mm]

  /// -du/dx inside and behind the contact; before it as ChebyshevField::continued_strain  [1]
  double strain(double x) const;

  /// u, likewise  [mm]
  double displacement(double x) const;

 private:
  double force_;
  double half_width_;
  ChebyshevField field_;
};

}  // namespace microslip
