// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Solves steady rolling of bodies of different material under Hertz's bound by UnlikeZones,
/// starting from the zones of a solution by elements.
///
/// Accuracy: 1e-8 of the creepage of free rolling without slip, and as much of tractions,
/// tests/unit/unlike_bodies_test.cpp. Cost: some 20 ms, and 1e-5 s for each node.
/// \param problem  with bodies of different material and Hertz's bound
/// \return its scheme is inversion; none if no zones are found that meet the conditions
std::optional<SteadySolution> unlike_by_inversion(const SteadyProblem& problem);

}  // namespace microslip
