// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/steady_patch.hpp"

namespace microslip {

/// An ellipse with c = 1 and mu p0 = G = 1, on which motions and forces have no units. Any number of
/// threads may use one.
class UnitPatch {
 public:
  struct Solution {
    Eigen::Vector3d forces;  ///< over mu F_n, and mu F_n c
    PatchState state;
  };

  /// \param cells  rows and elements of a circle
  UnitPatch(double ratio, double poisson_ratio, Eigen::Index cells);

  /// \param motion  xi, eta, phi c over mu p0/G
  /// \param start   the state of another motion; nullptr for none
  /// \throws NotConverged
  Solution solve(const Eigen::Vector3d& motion, const PatchState* start = nullptr) const;

  /// The forces of a motion, from the state of a smaller one if that leads to a solution, and else from
  /// none.
  /// \param state  in which a smaller motion ended, or none; becomes that of this motion
  /// \return       none, and no state, where there is no solution
  std::optional<Eigen::Vector3d> forces(const Eigen::Vector3d& motion,
                                        std::optional<PatchState>& state) const;

 private:
  SteadyPatch problem_;
  PatchResponse response_;
};

}  // namespace microslip
