// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"

namespace microslip::experiments::ellipse_wiggles_study {

/// The circle for which CONTACT was run.
SteadyPatch joined_circle(Eigen::Index rows, Eigen::Index elements);

/// How a circle rolls: after a shift by a force along, or from rest.
struct Rolling {
  const char* name;
  bool after_shift;
  PatchLoad load;
  Eigen::Index component;  ///< of force and tractions that are compared
};

/// A circle after some distance, in units of mu p0 and of full sliding.
struct RolledCircle {
  double distance = 0;         ///< [mm]
  Eigen::Vector3d resultants;  ///< over full sliding, and over full sliding times a
  Eigen::Vector3d motion;      ///< of the last step
  Eigen::MatrixX2d tractions;  ///< of all cells
  std::vector<bool> slips;     ///< of all cells
  Eigen::VectorXd line;        ///< tractions compared, at the stations
  std::vector<bool> sticks;    ///< at stations, and half an element about them
};

/// A step that was taken, of which the motion belongs to its middle.
struct Step {
  double middle, length;
  Eigen::Vector3d motion;
};

/// The course of a run.
struct Course {
  std::vector<RolledCircle> at;  ///< after each distance
  std::vector<Step> steps;
};

/// The stations: x of a row of N elements at y = a/N, from the trailing edge on.
Eigen::VectorXd stations(Eigen::Index elements);

/// Rolls by steps of a length, the last of which ends at each distance.
/// \param stations  N of them; those of the standard scheme are its own
Course rolled(PatchRolling scheme, const SteadyPatch& of, const Rolling& rolling, double step,
              const std::vector<double>& distances, Eigen::Index stations);
Course rolled(RectangleRolling scheme, const Rolling& rolling, double step,
              const std::vector<double>& distances);

}  // namespace microslip::experiments::ellipse_wiggles_study
