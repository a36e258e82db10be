// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"

namespace microslip {

/// Whether a creepage is above 0.2 in size.
bool is_large_creepage(double creepage);

/// Mean of the traction bound over the shear modulus.
double bound_strain(const TractionBound& bound, double shear_modulus);

/// The same with the shear modulus of the kernel; infinite if it has none.
double bound_strain(const TractionBound& bound, const Kernel& kernel);

/// Why a large creepage is doubtful: the theory is one of small creepages. Empty for small ones,
/// and in normalised contacts, whose mean bound is above 0.1 of the shear modulus.
std::string doubt_of_creepage(double creepage, double bound_strain);

}  // namespace microslip
