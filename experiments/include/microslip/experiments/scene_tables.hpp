// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// \file
/// Solves a scene. Tables: `traction`, one row per node; `summary`, with quantity, value and unit,
/// and with the rows of add_evidence; `history`, one row per step, unless rolling is steady; and
/// `shifts`, one row per shift, for a transient with TransientScene::shifts, or a patch with
/// PatchTransient::shifts; and `edges` of a patch. Progress counts shifts
/// and steps, thousandths of a cylinder's distance, or percents of the expected operations of a
/// steady solution.

std::vector<Table> scene_tables(const SteadyProblem& problem, const Progress& progress);
std::vector<Table> scene_tables(const SteadyTarget& target, const Progress& progress);
std::vector<Table> scene_tables(const SteadyPatch& patch, const Progress& progress);
std::vector<Table> scene_tables(const PatchTarget& target, const Progress& progress);
std::vector<Table> scene_tables(const TransientScene& scene, const Progress& progress);

/// \param at_end  called with the contact in its state after the last step
std::vector<Table> scene_tables(const TransientScene& scene, const Progress& progress,
                                const std::function<void(TransientRolling&)>& at_end);
std::vector<Table> scene_tables(const PatchTransient& scene, const Progress& progress);

/// \param at_end  called with the contact in its state after the last step, with Remembered
std::vector<Table> scene_tables(const PatchTransient& scene, const Progress& progress,
                                const std::function<void(const PatchRolling&)>& at_end);
std::vector<Table> scene_tables(const CylinderScene& scene, const Progress& progress);

}  // namespace microslip::experiments
