// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Steady rolling by inversion on any number of stick zones, sampled at the nodes of the problem.
/// The zones are those that graded elements show; find_stick_zones() makes them exact. The strain
/// that a strip's kernel adds to plane strain is iterated.
///
/// Accuracy: 1e-8 of force and creepage, tests/property/stick_zones_test.cpp.
/// Cost: some 300 graded elements, and 5 to 20 evaluations of integrals over the slip zones for
/// each zone; 0.05 s for two zones.
///
/// \return none for kernels that are no half-space, for bodies of different material, for tables of
///         more than 400 rows, or if no zones are found
std::optional<SteadySolution> solve_by_zones(const SteadyProblem& problem);

}  // namespace microslip
