// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/material_doubts.hpp"

#include <fmt/core.h>

#include "microslip/support/format.hpp"

namespace microslip {

namespace {

constexpr double largest_modulus = 1e6;  ///< of a solid; diamond has 5e5  [N/mm^2]
constexpr double least_modulus = 10;     ///< rubber has 1, and normalised contacts, too  [N/mm^2]

bool is_large(double traction, double shear_modulus) {
  constexpr double most_strain = 0.05;
  return traction > most_strain * shear_modulus;
}

}  // namespace

std::string doubt_of_modulus(double shear_modulus, double traction) {
  if (shear_modulus <= largest_modulus || is_large(traction, shear_modulus)) return "";
  return fmt::format("a shear modulus of {} N/mm^2, which is more than that of any solid",
                     format_roughly(shear_modulus));
}

std::string doubt_of_strain(double traction, double shear_modulus) {
  const bool is_normalised = shear_modulus < least_modulus || shear_modulus > largest_modulus;
  if (is_normalised || !is_large(traction, shear_modulus)) return "";
  return fmt::format(
      "the largest traction, {:.3g} N/mm^2, is {} of the shear modulus, {:.6g} N/mm^2, and strains "
      "have to be small",
      traction, format_roughly(traction / shear_modulus), shear_modulus);
}

}  // namespace microslip
