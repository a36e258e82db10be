// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Rolls one cylinder down a slope. Tables: traction (a row a node, at the end), history (a row a
/// step: motion, force and energies) and summary (a row a quantity).
std::vector<Table> cylinder_scene(const CylinderScene& scene, const Progress& progress);

}  // namespace microslip::experiments
