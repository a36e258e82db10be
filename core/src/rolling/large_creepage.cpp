// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/large_creepage.hpp"

#include <cmath>
#include <limits>
#include <variant>

namespace microslip {

bool is_large_creepage(double creepage) { return std::abs(creepage) > 0.2; }

double bound_strain(const TractionBound& bound, double shear_modulus) {
  return full_sliding_force(bound) / (2 * half_width_of(bound)) / shear_modulus;
}

double bound_strain(const TractionBound& bound, const Kernel& kernel) {
  return kernel.has_material() ? bound_strain(bound, kernel.material().shear_modulus)
                               : std::numeric_limits<double>::infinity();
}

std::string doubt_of_creepage(double creepage, double bound_strain) {
  constexpr double most_strain = 0.1;
  if (!is_large_creepage(creepage) || bound_strain > most_strain) return "";
  return "creepages above 0.2 are not small against 1, as the theory has them, and errors are of "
         "their size where part of the contact sticks; 0.2 % is 0.002";
}

}  // namespace microslip
