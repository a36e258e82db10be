// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <vector>

#include "microslip/patch/steady_patch.hpp"
#include "microslip/scene/model.hpp"

namespace microslip::experiments {

/// The part of a solution that errors are measured of.
struct Outcome {
  Eigen::VectorXd distance;  ///< at the start and after each step; steady rolling has one, 0  [mm]
  /// The force; if the force is prescribed, the creepage, and in transients the creep so far. Empty
  /// in a patch.
  Eigen::VectorXd answer;
  Eigen::VectorXd x;
  Eigen::VectorXd traction;  ///< at the end  [N/mm^2]
  double lost = 0;           ///< dissipated energy  [N/mm or N]
  double longest_step = 0;   ///< time of the longest step except for the first  [s]

  struct Patch {
    SteadyPatch problem;
    SteadyPatchSolution solution;
  };
  std::optional<Patch> patch = std::nullopt;

  /// A patch after its shifts and steps.
  struct PatchSteps {
    double size;                              ///< c  [mm]
    std::vector<Eigen::Vector3d> resultants;  ///< over the largest ones  [1]
    std::vector<Eigen::Vector3d> ways;        ///< crept so far, by the bodies  [mm, mm, rad]
  };
  std::optional<PatchSteps> patch_steps = std::nullopt;

  /// Counts the steps of a transient; steady rolling counts as one step.
  double steps() const { return std::max(1.0, static_cast<double>(distance.size() - 1)); }

  bool has_answer() const;
};

/// Solves a scene.
/// \throws std::invalid_argument for scenes that `converge` does not take, NotConverged
Outcome solved(const Model& model);

/// Relative errors.
struct Errors {
  /// In a patch as change_of(); of steps the largest one of resultants after each step over the
  /// largest that friction carries, and of the ways crept over the longest of their kind.
  double answer;
  double traction;  ///< not given in a patch
  double energy;
};

Errors errors_of(const Outcome& outcome, const Outcome& exact);

}  // namespace microslip::experiments
