// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/steady.hpp"

namespace microslip::experiments {

/// The shortest step, or the shortest memory, with which a step from steady rolling has one solution
/// by linear theory: the spectral radius of R diag(g m). Slip of the zone that slips follows its
/// tractions with R, where what sticks goes on to stick, and tractions follow slip with g m:
/// without a memory m = -V d(ratio)/ds in steps of dq, a radius in mm; with a memory m = (v
/// |d(ratio)/dv| + ratio - law(v)), v = |s| V, a radius in mm, too (docs/theory.md).
/// \param problem   with friction, by elements
/// \param solution  of it
double limit_of_unique_steps(const SteadyProblem& problem, const SteadySolution& solution);

/// The bound at equal elements in contact by the discrete normal problem of a cylinder on a plane,
/// as CONTACT solves it for the pressure: equations at the centres of elements of constant pressure.
/// \param bound    Hertz's, of the same load
/// \param spacing  of the elements, whose middle one is at the centre  [mm]
/// \return a table at the elements in contact, with edges half an element beyond the outermost
TabulatedBound bound_by_elements(const Material& material, const Kernel& kernel,
                                 const HertzBound& bound, double spacing);

}  // namespace microslip::experiments
