// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "microslip/friction/friction_law.hpp"
#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/patch_history.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// Reads contact.friction_law and the keys that go with it, and load.speed.
/// \return none without contact.friction_law
std::optional<SlipFriction> read_slip_friction(Scene& scene);

/// The same of a run. Where its rows have times, the speed is theirs.
std::optional<SlipFriction> read_slip_friction(Scene& scene, const LoadHistory& loads);
std::optional<SlipFriction> read_slip_friction(Scene& scene, const PatchHistory& loads);

}  // namespace microslip
