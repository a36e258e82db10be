// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/large_motion.hpp"

#include <fmt/core.h>

#include <cmath>

#include "microslip/rolling/large_creepage.hpp"
#include "microslip/support/format.hpp"

namespace microslip {

double mean_strain(const SteadyPatch& patch) {
  return patch.bound.total() / patch.bound.shape().area() / patch.material.shear_modulus;
}

std::string doubt_of_large_motion(std::size_t component, double motion, const SteadyPatch& patch) {
  const double size = component == 2 ? patch.bound.size() : 1;
  if (!is_large_creepage(size * motion)) return "";  // before the strain is computed
  return doubt_of_large_motion(component, motion, patch.bound.size(), mean_strain(patch));
}

std::string doubt_of_large_motion(std::size_t component, double motion, double size,
                                  double strain) {
  const bool is_spin = component == 2;
  const double slip = is_spin ? size * motion : motion;
  const std::string doubt = doubt_of_creepage(slip, strain);
  if (doubt.empty() || !is_spin) return doubt;
  return fmt::format(
      "the slip by this spin, up to {} at the sides of the contact, is not small against 1, as the "
      "theory has it; 0.2 1/m is 2e-4",
      format_roughly(std::abs(slip)));
}

}  // namespace microslip
