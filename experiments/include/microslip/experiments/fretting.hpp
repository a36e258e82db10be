// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Shifts without rolling under a force that goes to and fro: loops and dissipation against
/// Mindlin's exact solution, and for another bound against superposition; then standstill, rolling
/// and standstill in one run, with its balance of energy. Forces are parts of full sliding.
struct FrettingParameters {
  Material material;
  double length;                     ///< L0 of plane strain  [mm]
  PolynomialBound bound;             ///< no Hertz's; the Hertzian one has its force and half-width
  std::vector<Eigen::Index> sizes;   ///< N, ascending; loops have the last
  std::vector<double> forces;        ///< amplitudes of the loops, ascending in (0, 1)
  int points;                        ///< of a loop on each way, >= 2
  std::vector<double> error_forces;  ///< amplitudes over which errors are taken, likewise
  std::vector<double> all_forces;    ///< amplitudes of the curve of dissipation, likewise
  std::vector<double> lengths;       ///< of plane strain, other L0, >= 1  [half-widths]
  Eigen::Index run_elements;         ///< N of the run, and of other L0
  double run_force;                  ///< under which the bodies roll, in (-1, 1), not 0
  double run_swing;                  ///< amplitude about it at standstill; their sum is below 1
  double run_distance;               ///< rolled each time  [elements]
  double run_step_ratio;             ///< c, in [1e-3, 5]
};

/// The keys that `fretting --print-keys` lists, each held to what that says it accepts.
FrettingParameters read_fretting(Scene& scene);

/// Tables: loops (force and displacement), cycles (each with its errors), errors (against N),
/// orders, curve (dissipation against the amplitude), lengths (the same for each L0), run (energies
/// on the way), claims.
std::vector<Table> fretting(const FrettingParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
