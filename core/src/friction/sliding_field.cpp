// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/sliding_field.hpp"

#include <stdexcept>

namespace microslip {

namespace {

ChebyshevField field_of(const Kernel& kernel, const TractionBound& bound) {
  const auto smooth = chebyshev_traction(bound);
  if (!smooth) throw std::invalid_argument("bound: expected a smooth one, not a table");
  return ChebyshevField(kernel, *smooth);
}

}  // namespace

SlidingField::SlidingField(const Kernel& kernel, const TractionBound& bound)
    : force_(full_sliding_force(bound)),
      half_width_(half_width_of(bound)),
      field_(field_of(kernel, bound)) {}

double SlidingField::strain(double x) const {
  return x > -half_width_ ? field_.continued_strain(x) : field_.strain(x);
}

double SlidingField::displacement(double x) const {
  return x > -half_width_ ? field_.continued_displacement(x) : field_.displacement(x);
}

}  // namespace microslip
