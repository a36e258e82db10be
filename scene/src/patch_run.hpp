// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/patch/steady_patch.hpp"
#include "microslip/rolling/advection.hpp"
#include "microslip/rolling/patch_history.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// The run of load.file for a patch, with load.radius if the file has a column omega. Columns of
/// the contact are divided by the problem's values, as in read_run().
/// \param patch   its load has the components that are not in the file
/// \param scheme  Remembered where the contact changes
/// \throws std::invalid_argument with a message that names the file, and the line or row and column
PatchHistory read_patch_run(Scene& scene, const SteadyPatch& patch, const AdvectionScheme& scheme);

/// Refuses motions, or shifts, of more than 1e8 times those by the bound's strain, beside which
/// displacements would be lost.
/// \throws BadParameter with the name of the component, see name_of()
void require_motions(const PatchLoad& load, const SteadyPatch& patch, bool are_shifts = false);

/// Calls an action; a message about a component of a load is then about its key, or its column.
/// \param names  called with the number of the component
template <class Action, class Name>
void with_names_of(const PatchLoad& load, const Action& action, const Name& name) {
  try {
    action();
  } catch (const BadParameter& error) {
    for (std::size_t j = 0; j < load.size(); ++j) {
      const std::string known = name_of(load, j);
      if (error.name() != known) continue;
      throw BadParameter(name(j), name(j) + std::string(error.what()).substr(known.size()));
    }
    throw;
  }
}

}  // namespace microslip
