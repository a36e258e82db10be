// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// A contact of which the curve of creepage and force is wanted.
struct CurveScene {
  SteadyProblem problem;                ///< its load has no part in it
  std::vector<double> creepages;        ///< in rising order; if there are none:
  int points;                           ///< evenly spaced from 0 on, or below 0 of unlike bodies
  std::optional<double> largest;        ///< up to this; without it, a quarter beyond full sliding
  bool with_fastsim;                    ///< the curve of Fastsim beside it
  std::optional<double> friction = {};  ///< where the scene has it, for the traction coefficient
};

/// All keys of a steady scene except for load.*, which has no part in it, and curve.creepages or
/// curve.points (51) and curve.largest, curve.beside nothing|fastsim (nothing). Transients and
/// cylinders give their contact, which is solved by inversion.
/// \throws std::invalid_argument for target_error, and for FASTSIM of bodies of different material
CurveScene read_curve(Scene& scene);

/// Tables: curve (the force at each creepage, by the method of the scene) and summary (full
/// sliding, the slope without creepage).
/// \throws NotConverged if a point has no solution
std::vector<Table> curve_tables(const CurveScene& scene, const Progress& progress);

}  // namespace microslip::experiments
