// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <string>

#include "microslip/experiments/patch_curve_scene.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/program/memory.hpp"
#include "microslip/program/run.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/support/require.hpp"

/// \file
/// How a scene is solved, from the command line and from Python.

namespace microslip {

/// In a case of a sweep, its section has been taken out.
inline void reject_sweep(const Scene& scene, const std::string& advice) {
  for (const std::string& key : scene.keys()) {
    if (!key.starts_with("sweep.")) continue;
    throw BadParameter(key,
                       fmt::format("key '{}': expected a scene without a sweep; {}", key, advice));
  }
}

/// Refuses a sweep over the motion that a curve varies, or over its resultant: its curves would all
/// be equal.
inline void reject_sweep_of_varied(const Scene& scene) {
  const bool is_patch = scene.has_patch();
  const bool is_given = is_patch && scene.has("curve.along");
  const std::string along = is_given ? scene.text("curve.along") : "creepage";
  const std::string resultant = along == "creepage"           ? "force"
                                : along == "lateral_creepage" ? "lateral_force"
                                                              : "spin_moment";
  for (const std::string& varied :
       {along, resultant, resultant + "_ratio", std::string("stick_ratio")}) {
    const std::string key = "sweep.load." + varied;
    const bool is_another = varied == "stick_ratio" && is_patch;
    if (is_another || !scene.has(key) || scene.has("sweep.curve.along")) continue;
    throw BadParameter(key, fmt::format("key '{}': expected another key, as the curves vary the {} "
                                        "({}) and would all be equal",
                                        key, along, is_patch ? "curve.along" : "curve.creepages"));
  }
}

/// Reads a scene of any problem.
/// \return its tables
inline program::Work solver_of(Scene& scene) {
  const Model model = read_model(scene);
  program::require_memory("grid.elements", elements_of(model), memory_needed(model));
  return [model](const Progress& progress) {
    return std::visit([&](const auto& read) { return experiments::scene_tables(read, progress); },
                      model);
  };
}

/// Reads the curve of an ellipse or another patch.
/// \return its tables
inline program::Work patch_curve_of(Scene& scene) {
  const experiments::PatchCurveScene read = experiments::read_patch_curve(scene);
  program::require_memory("grid.elements", read.patch.elements, memory_needed(read.patch));
  return [read](const Progress& progress) { return experiments::curve_tables(read, progress); };
}

}  // namespace microslip
