// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Steady rolling under a table by elements that resolve it, sampled at the nodes of the problem:
/// elements graded towards steep pieces and the ends of zones where their matrix is cheap, or else
/// as many equal elements as it takes. Evidence::change is the change from elements twice as long.
/// \param why  the inversion does not serve
SteadySolution solve_on_resolved_elements(const SteadyProblem& problem, const std::string& why);

}  // namespace microslip
