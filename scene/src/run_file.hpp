// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// The run of load.file, with load.radius if the file has a column omega. Columns of the contact
/// are divided by the problem's values: normal_load by contact.normal_load, and so on.
/// \param problem  its bound limits forces, and its kernel limits the half-widths of contacts that
///                 change
/// \throws std::invalid_argument with a message that names the file, and the line or row and column
LoadHistory read_run(Scene& scene, const TransientProblem& problem);

/// The scene's values of the quantities in the columns of the contact.
/// \throws std::invalid_argument for a column without such a value
RunRows::Reference reference_of(Scene& scene, const RunRows& rows);

/// Whether the run starts under the force of its first row, see RunRows: not at rest, and not under
/// tractions of a file.
bool starts_under_force(const Scene& scene);

/// Refuses schemes that do not roll on a contact that changes.
void require_scheme_of_changes(const AdvectionScheme& scheme);

/// Refuses schemes that do not roll back, for a load that does so all the way.
void require_scheme_of_direction(const AdvectionScheme& scheme, const LoadHistory& loads);

/// Refuses schemes, steps and starts that do not go with a load that turns or shifts the bodies.
void require_scheme_of_stops(Scene& scene, const AdvectionScheme& scheme);

/// The steps from row to row, dq/dx; without those of length 0, in which nothing happens  [1]
/// \param rows     their distances  [mm]
/// \param spacing  dx  [mm]
std::vector<double> row_ratios(const std::vector<double>& rows, double spacing);

}  // namespace microslip
