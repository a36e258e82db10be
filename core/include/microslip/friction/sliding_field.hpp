// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/chebyshev_field.hpp"

namespace microslip {

/// The field of the bound as a traction. \throws BadParameter for a table, and as ChebyshevField
ChebyshevField sliding_field_of(const Kernel& kernel, const TractionBound& bound);

/// Strain and displacement of the half-space in full sliding, where the traction is the bound;
/// exact to rounding.
class SlidingField {
 public:
  /// \throws as sliding_field_of
  SlidingField(const Kernel& kernel, const TractionBound& bound);

  double force() const { return force_; }  ///< [N/mm]

  /// -du/dx inside and behind the contact; ahead of it, ChebyshevField::continued_strain  [1]
  double strain(double x) const;

  /// u; ahead of the contact, ChebyshevField::continued_displacement  [mm]
  double displacement(double x) const;

 private:
  double force_;
  double half_width_;
  ChebyshevField field_;
};

}  // namespace microslip
