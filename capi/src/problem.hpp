// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace microslip::capi
