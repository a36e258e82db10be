// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "microslip/patch/steady_patch.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// \file
/// Parts of a contact patch in scenes, for steady rolling and for steps.

/// A component's keys: of its motion, of its resultant, and of the resultant's ratio to the largest.
struct PatchKeys {
  const char* motion;
  const char* resultant;
  const char* ratio;
};

inline constexpr std::array<PatchKeys, 3> patch_components{{
    {"load.creepage", "load.force", "load.force_ratio"},
    {"load.lateral_creepage", "load.lateral_force", "load.lateral_force_ratio"},
    {"load.spin", "load.spin_moment", "load.spin_moment_ratio"},
}};

/// All of these keys.
std::vector<std::string> keys_of_patch_loads();

/// Reads material.*, contact.*, grid.rows and grid.elements.
SteadyPatch read_unloaded_patch(Scene& scene);

/// Whether the scene has a key of a component.
bool has_patch_load(const Scene& scene);

/// Reads load.* of all components; the motion of one that is not given is 0.
PatchLoad read_patch_load(Scene& scene, const PatchBound& bound);

/// Warns of prescribed motions as warn_of_large_motion().
void warn_of_large_motions(Scene& scene, const SteadyPatch& patch);

}  // namespace microslip
