// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "microslip/patch/steady_patch.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// Values at the centres of the elements of a patch; for the units see SteadyPatchSolution.
struct PatchValues {
  const Eigen::VectorXd& x;
  const Eigen::VectorXd& y;
  const Eigen::VectorXd& area;
  const Eigen::VectorXd& bound;
  const Eigen::MatrixX2d& traction;
  const Eigen::MatrixX2d& slip;
  const std::vector<bool>& slips;
};

/// Where values on joined rows are, for a description.
inline constexpr const char* at_cells =
    " of a patch, values at the centres of cells, from the leading edge on, row by row";

/// The table `traction` of a patch, a row for each element.
Table patch_traction_table(const std::string& description, const PatchValues& values);

/// The table `edges`: the sides of rows, and some between them where there are few.
/// \param size  of the contact, over the patch's  [1]
Table patch_edges_table(const SteadyPatch& patch, double size = 1);

/// The table `edges` of equal rectangles, row by row.
/// \param x, y    of the centres, in the order of the rows  [mm]
/// \param dx, dy  sides of a rectangle  [mm]
Table rectangles_edges_table(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double dx,
                             double dy);

/// Resultants below this are rounding, over full sliding, and for the moment over that at the
/// distance c.
inline constexpr double rounding_of_resultants = 1e-9;

/// Adds resultants and motion to the table `summary`.
void add_patch_load(Table& summary, const Eigen::Vector3d& resultants,
                    const Eigen::Vector3d& motion, const PatchBound& bound);

/// Adds the force over full sliding, and the shares of the area that stick and slip.
/// \param full_sliding, force  [N]
/// \param slip_share           [1]
void add_patch_shares(Table& summary, double full_sliding, double force, double slip_share);

/// Adds the sizes of the contact and of the grid.
/// \param size  of the contact, over the patch's  [1]
void add_patch_sizes(Table& summary, const SteadyPatch& patch, double size = 1);

/// Warns of a result that other rows and elements change.
std::optional<std::string> doubt_of_patch(const Evidence& evidence);

}  // namespace microslip::experiments
