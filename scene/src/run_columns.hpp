// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// The columns that load.file may have, in a patch also those of the other components, with their
/// names in the file if load.columns gives them.
/// \throws BadParameter for a load.columns that names other columns, or one of them twice
std::vector<FileColumn> run_columns(Scene& scene);

/// Requires a distance or times with velocities, and one load.
/// \param wanted  by run_columns()
/// \param found   the columns that are wanted, in their order
/// \throws std::invalid_argument with the names of the file, and which of them may be meant
void require_run(Scene& scene, const std::vector<FileColumn>& wanted,
                 const std::vector<std::optional<Eigen::VectorXd>>& found);

/// The same of a patch: at most one column for each component, and one for some component.
void require_patch_run(Scene& scene, const std::vector<FileColumn>& wanted,
                       const std::vector<std::optional<Eigen::VectorXd>>& found);

}  // namespace microslip
