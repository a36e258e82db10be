// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/sliding_field.hpp"

#include "microslip/support/require.hpp"

namespace microslip {

ChebyshevField sliding_field_of(const Kernel& kernel, const TractionBound& bound) {
  const auto smooth = chebyshev_traction(bound);
  if (!smooth) {
    throw BadParameter(
        "bound", "bound: expected no table, because Chebyshev polynomials want a smooth bound");
  }
  return ChebyshevField(kernel, *smooth);
}

SlidingField::SlidingField(const Kernel& kernel, const TractionBound& bound)
    : force_(full_sliding_force(bound)),
      half_width_(half_width_of(bound)),
      field_(sliding_field_of(kernel, bound)) {}

double SlidingField::strain(double x) const {
  return x > -half_width_ ? field_.continued_strain(x) : field_.strain(x);
}

double SlidingField::displacement(double x) const {
  return x > -half_width_ ? field_.continued_displacement(x) : field_.displacement(x);
}

}  // namespace microslip
