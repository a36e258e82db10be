// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// The mean of the traction bound over the shear modulus.
double mean_strain(const SteadyPatch& patch);

/// Why a motion is doubtful by which slip in the contact is above 0.2; empty if it is not, and in
/// normalised contacts, see doubt_of_creepage().
/// \param component  0, 1 or 2: along, across or spin
/// \param motion     [1], of spin [1/mm]
std::string doubt_of_large_motion(std::size_t component, double motion, const SteadyPatch& patch);

/// The same by numbers.
/// \param size    c of the contact, (a b)^(1/2) of an ellipse  [mm]
/// \param strain  the mean of the traction bound over the shear modulus
std::string doubt_of_large_motion(std::size_t component, double motion, double size, double strain);

}  // namespace microslip
