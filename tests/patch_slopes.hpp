// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// A load by motions alone.
inline PatchLoad rolling_by(const Eigen::Vector3d& motion) {
  return {{{false, motion[0]}, {false, motion[1]}, {false, motion[2]}}};
}

/// The resultants by the motion, as central differences; none if other cells slip at their ends.
inline std::optional<Eigen::Matrix3d> slopes_of(SteadyPatchSolver& patch,
                                                const Eigen::Vector3d& motion, double step) {
  const std::vector<bool> slips = patch.solve(rolling_by(motion)).slips;
  Eigen::Matrix3d slopes;
  for (int j = 0; j < 3; ++j) {
    const Eigen::Vector3d change = step * Eigen::Vector3d::Unit(j);
    const auto ahead = patch.solve(rolling_by(motion + change));
    const auto behind = patch.solve(rolling_by(motion - change));
    if (ahead.slips != slips || behind.slips != slips) return std::nullopt;
    slopes.col(j) = (ahead.resultants - behind.resultants) / (2 * step);
  }
  return slopes;
}

}  // namespace microslip
