// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// "A" in adhesion, "S" in slip.
std::string region(Zone zone);

/// Solves one steady problem. Tables: traction (a row a node) and summary (a row a quantity).
std::vector<Table> steady_scene(const SteadyProblem& problem);

}  // namespace microslip::experiments
