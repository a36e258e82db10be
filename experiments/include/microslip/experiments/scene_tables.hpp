// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// \file
/// Solves a scene. Tables: `traction`, a row a node; `summary`, quantity, value and unit, with the
/// evidence of add_evidence; `history`, a row a step, of what is not steady; and `shifts`, a row a
/// shift, of a transient with TransientScene::shifts. Progress counts shifts and steps, thousandths
/// of a cylinder's way, or percents of the operations that a steady solution is expected to take.

std::vector<Table> scene_tables(const SteadyProblem& problem, const Progress& progress);
std::vector<Table> scene_tables(const SteadyTarget& target, const Progress& progress);
std::vector<Table> scene_tables(const TransientScene& scene, const Progress& progress);

/// \param at_end  called with the contact after the last step, as that has left it
std::vector<Table> scene_tables(const TransientScene& scene, const Progress& progress,
                                const std::function<void(TransientRolling&)>& at_end);
std::vector<Table> scene_tables(const CylinderScene& scene, const Progress& progress);

}  // namespace microslip::experiments
