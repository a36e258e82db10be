// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip.h"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::capi {

/// Makes the problem that the structs of C describe.
/// \throws std::invalid_argument for what is out of its range, and for parts of a table that is not
///                               whole
TransientProblem make_problem(const microslip_material& material, const microslip_contact& contact,
                              const microslip_kernel& kernel, const microslip_grid& grid);

/// The same for bodies of different material.
TransientProblem make_problem(const microslip_material& material, const microslip_unlike& unlike,
                              const microslip_contact& contact, const microslip_kernel& kernel,
                              const microslip_grid& grid);

/// The same of steady rolling by its default method, free for now.
/// \param elements  N nodes, and elements where the method needs some
/// \throws std::invalid_argument likewise
SteadyProblem make_steady_problem(const microslip_material& material,
                                  const microslip_contact& contact, const microslip_kernel& kernel,
                                  int elements);

/// Why numbers that are accepted may have other units: the modulus, or the largest traction beside it.
/// \param peak  of the bound, > 0  [N/mm^2]
/// \return empty if there is no doubt
std::string doubt_of_units(const microslip_material& material, double peak);

/// The same for a line contact.
std::string doubt_of_units(const microslip_material& material, const TractionBound& bound);

}  // namespace microslip::capi
