// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/patch/steady_patch.hpp"
#include "microslip/reference/creep_force_laws.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// A contact patch of which forces and moment are wanted over one motion.
struct PatchCurveScene {
  SteadyPatch patch;                 ///< with the load of the other components
  std::size_t along;                 ///< the component that varies: 0, 1 or 2
  std::vector<double> motions = {};  ///< its values, in rising order; if there are none:
  int points = 0;                    ///< evenly spaced ones
  bool is_symmetric = true;          ///< they begin at 0; otherwise at the negative of the largest
  std::optional<double> largest = {};  ///< up to this; without it, a quarter beyond sliding
  std::vector<std::string> laws = {};
  /// The contact as these laws take it; none without laws.
  std::optional<CreepForceContact> contact = {};
  std::optional<double> friction = {};  ///< where the scene has it, for the traction coefficient
};

/// Reads all keys of a steady scene of an ellipse or another patch; curve.along creepage (default),
/// lateral_creepage or spin, whose load has no part in it; curve.creepages, or curve.spins [1/mm], or
/// curve.points (51) with curve.largest or curve.largest_spin; curve.beside, one or more of fastsim,
/// fastsim_one, vermeulen_johnson and polach, for Hertz's bound on an ellipse, with
/// curve.kalker_factor.
/// \throws std::invalid_argument
PatchCurveScene read_patch_curve(Scene& scene);

/// Returns two tables: curve (motions, resultants and those of the laws at each motion) and summary
/// (full sliding, Kalker's coefficients, the largest errors of the laws).
/// \throws NotConverged if a point has no solution
std::vector<Table> curve_tables(const PatchCurveScene& scene, const Progress& progress);

}  // namespace microslip::experiments
