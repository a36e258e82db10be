// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// The run of load.file, with load.radius if it has a column omega. Its columns of the contact are
/// taken over those of the problem's: normal_load over contact.normal_load, and so on.
/// \param problem  forces keep its bound; of contacts that change, half-widths fit its kernel
/// \throws std::invalid_argument that names file, and line or row and column
LoadHistory read_run(Scene& scene, const TransientProblem& problem);

/// The steps from row to row, dq/dx  [1]
/// \param spacing  dx  [mm]
std::vector<double> row_ratios(const LoadHistory& loads, double spacing);

}  // namespace microslip
