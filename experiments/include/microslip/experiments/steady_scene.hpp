// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Solves one steady problem. Tables: traction (a row a node) and summary (a row a quantity).
std::vector<Table> steady_scene(const SteadyProblem& problem);

/// The same by what is cheapest for a target; the summary says what was picked, and the estimated
/// relative error of what is not prescribed.
std::vector<Table> steady_scene(const SteadyTarget& target);

}  // namespace microslip::experiments
