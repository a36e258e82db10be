// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Which method for creep forces of a contact ellipse has which error, and which cost? The installed
/// table of creep forces, the layout of USETAB, fast laws, CONTACT on few elements and direct solutions
/// on few cells, against direct solutions on many cells.
struct CreepTablesParameters {
  Eigen::Index groups = 0;      ///< random a/b
  Eigen::Index states = 0;      ///< random motions at each of them
  Eigen::Index every = 0;       ///< of CONTACT's magnitudes of the creepage
  Eigen::Index cells = 0;       ///< of a circle, and one more: references are means of both
  Eigen::Index fine_cells = 0;  ///< the same, for the errors of references
  Eigen::Index fine_groups = 0,
               fine_states = 0;        ///< random a/b that are solved on these, and motions
  std::vector<Eigen::Index> direct{};  ///< cells of direct solutions that are compared
  Eigen::Index fastsim_cells = 0;      ///< rows, and elements of each
  Eigen::Index usetab_cells = 0;       ///< at the nodes of USETAB's layout, and one more
};

/// The keys that `creep_tables --print-keys` lists, each checked against its listed range.
CreepTablesParameters read_creep_tables(Scene& scene);

/// Tables: states (with the references), reference (its errors), errors, ratios (errors over a/b),
/// distribution (shares of states above an error), cost_timing (measured times, which differ from run to
/// run), claims. Poisson's ratio is 0.28, that of the installed table and of CONTACT's cases.
std::vector<Table> creep_tables(const CreepTablesParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
