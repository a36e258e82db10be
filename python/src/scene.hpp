// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "interface.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip::python {

/// \throws std::invalid_argument for what is none
Scene scene_of(const microslip_py_scene& given);

/// As with_places(), but the error still knows its key.
template <class Action>
auto placed(const Scene& scene, Action action) {
  try {
    return action();
  } catch (const BadParameter& error) {
    const BadParameter named = in_keys(error, scene);
    throw BadParameter(named.name(), scene.place_of(named.name()) + named.what());
  }
}

/// Reads a contact that rolls from a scene.
/// \throws std::invalid_argument as read_transient_problem, and for a key that nobody reads
TransientProblem rolling_of(Scene scene);

/// The same in steady rolling, free for now.
/// \param scene  gets the warnings
SteadyProblem steady_of(Scene& scene);

/// A contact patch of a scene, whose load is left out.
struct PatchOfScene {
  SteadyPatch patch;
  std::string scheme;  ///< as step.scheme names it
};

/// Reads the contact patch of a scene. What the scene says about its problem, load, steps, start,
/// motion and curve is left out, but for the scheme.
/// \param scene  gets the warnings
/// \throws std::invalid_argument likewise, and for a line contact
PatchOfScene patch_of(Scene& scene);

/// Makes a scene of steady rolling of one of a patch by steps.
void leave_out_steps(Scene& scene);

/// The lines of warnings.
std::string lines_of(const std::vector<Warning>& warnings);

}  // namespace microslip::python
