// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Steady rolling of a brush under any bound, in closed form. A spring that sticks is stretched by
/// the creepage times the way that it rolls, so with m = |w|/C the traction is the lower envelope
/// \f[ |p(x)| = \min_{x' \ge x} \bigl( g(x') + m (x' - x) \bigr) . \f]
/// Accuracy: 1e-12 of force and creepage; tests/unit/brush_rolling_test.cpp.
/// Cost: one pass over the rows of a table, or over 4000 places of a smooth bound, for each
/// creepage that is tried under a force.
/// \param problem  with a WinklerKernel, and bodies of the same material
/// \throws std::invalid_argument if a force is not below full sliding
SteadySolution solve_brush(const SteadyProblem& problem);

}  // namespace microslip
