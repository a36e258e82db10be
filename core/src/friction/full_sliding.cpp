// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/full_sliding.hpp"

#include <stdexcept>

namespace microslip {

namespace {

ChebyshevField field_of(const Kernel& kernel, const TractionBound& bound) {
  const auto smooth = chebyshev_traction(bound);
  if (!smooth) throw std::invalid_argument("bound: expected a smooth one, not a table");
  return ChebyshevField(kernel, *smooth);
}

}  // namespace

FullSliding::FullSliding(const Kernel& kernel, const TractionBound& bound)
    : force_(full_sliding_force(bound)),
      half_width_(half_width_of(bound)),
      field_(field_of(kernel, bound)) {}

double FullSliding::strain(double x) const {
  return x > -half_width_ ? field_.continued_strain(x) : field_.strain(x);
}

double FullSliding::displacement(double x) const {
  return x > -half_width_ ? field_.continued_displacement(x) : field_.displacement(x);
}

}  // namespace microslip
