// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "microslip/scene/model.hpp"

namespace microslip {

/// read_steady() without a load: one that is given has no part in it, and none has to be.
/// \return under a creepage of zero
SteadyProblem read_unloaded_steady(Scene& scene);

/// read_steady_patch() of which one component has a motion that varies: its load has no part, and
/// no component must have one.
/// \param varied  0, 1 or 2: along, across or spin
/// \return with that motion zero
SteadyPatch read_steady_patch(Scene& scene, std::size_t varied);

/// Warns of a motion by which slip in the contact is above 0.2, as warn_of_large_creepage() does.
/// \param component  0, 1 or 2: along, across or spin
void warn_of_large_motion(Scene& scene, const std::string& key, std::size_t component,
                          double motion, const SteadyPatch& patch);

}  // namespace microslip
