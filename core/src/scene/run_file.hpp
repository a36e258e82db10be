// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/rolling/load_history.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// The run of load.file, with load.radius if it has a column omega.
/// \param bound  that forces keep
/// \throws std::invalid_argument that names file, and line or row and column
LoadHistory read_run(Scene& scene, const TractionBound& bound);

/// The steps from row to row, dq/dx  [1]
/// \param spacing  dx  [mm]
std::vector<double> row_ratios(const LoadHistory& loads, double spacing);

}  // namespace microslip
