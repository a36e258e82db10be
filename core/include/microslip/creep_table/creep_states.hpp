// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "microslip/creep_table/creep_table.hpp"

namespace microslip {

/// Steady rolling of an ellipse under a motion, in the quantities of CreepTable.
struct CreepState {
  double ratio;            ///< a/b
  Eigen::Vector3d motion;  ///< xi, eta, phi c over mu p0/G
  Eigen::Vector3d forces;  ///< over mu F_n, and mu F_n c
};

/// Random motions of one random a/b of a layout, solved: sizes t are uniform from 0 to 1, and
/// directions are uniform in (kx xi, ky eta, kp phi c). Another seed has other states.
/// \param count   states
/// \param cells   states are means of solutions on so many rows and elements of a circle, 4 ... 40, and
///                on one more
/// \return        fewer states than `count` where some have no solution
/// \throws std::invalid_argument outside the ranges
std::vector<CreepState> random_creep_states(const CreepTableLayout& layout, std::uint64_t seed,
                                            std::size_t count, Eigen::Index cells);

/// The errors of a table in these states.
/// \param states  at least one
CreepTableErrors errors_in(const std::vector<CreepState>& states, const CreepTable& table,
                           Eigen::Index cells);

}  // namespace microslip
