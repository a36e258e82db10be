// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Rolls one scene. Tables: traction (a row a node, at the end), history (a row a step, and one for
/// the start) and summary (a row a quantity).
std::vector<Table> transient_scene(const TransientScene& scene, const Progress& progress);

}  // namespace microslip::experiments
