// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Solves steady rolling on the elements of the problem's grid, whose method is `differences`.
/// \throws as solve_steady
SteadySolution by_differences(const SteadyProblem& problem, const Differences& differences);

}  // namespace microslip
