// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Solves one steady problem. Tables: traction (a row a node) and summary (a row a quantity).
std::vector<Table> steady_scene(const SteadyProblem& problem);

}  // namespace microslip::experiments
