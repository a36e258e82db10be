// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/transient.hpp"

namespace microslip {

/// Tractions at the nodes of a transient's grid, from the tractions of a table. Rows at the nodes
/// are used unchanged. Otherwise the ratio to the bound is interpolated linearly between rows where
/// the bound is not zero, and held constant next to the edges: outwards from an outermost row by at
/// most the distance to the neighbouring row, as far as an element may reach.
///
/// \param x         ascending  [mm]
/// \param traction  at x, within the bound  [N/mm^2]
/// \throws std::invalid_argument outside the ranges, or if the table ends before a node within the
///                               contact
Eigen::VectorXd traction_at_nodes(const Eigen::VectorXd& x, const Eigen::VectorXd& traction,
                                  const TransientProblem& problem);

}  // namespace microslip
