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

/// Shifts without rolling under an oscillating force: loops and dissipation are compared with
/// Mindlin's exact solution, and for another bound with superposition. A further run has
/// standstill, rolling and standstill, with its energy balance. Forces are fractions of full
/// sliding.
struct FrettingParameters {
  Material material;
  double length = 0;                   ///< L0 of plane strain  [mm]
  PolynomialBound bound;               ///< a bound that is not Hertzian; the Hertzian bound has the
                                       ///< same force and half-width
  std::vector<Eigen::Index> sizes{};   ///< N, ascending; loops have the last
  std::vector<double> forces{};        ///< amplitudes of the loops, ascending in (0, 1)
  int points = 0;                      ///< of a loop on each way, >= 2
  std::vector<double> error_forces{};  ///< amplitudes over which errors are taken, likewise
  std::vector<double> all_forces{};    ///< amplitudes of the curve of dissipation, likewise
  std::vector<double> lengths{};       ///< of plane strain, other L0, >= 1  [half-widths]
  Eigen::Index run_elements = 0;       ///< N of the run, and of other L0
  double run_force = 0;                ///< force during rolling, in (-1, 1), not 0
  double run_swing = 0;                ///< amplitude about run_force at standstill
  double run_distance = 0;             ///< rolled each time  [elements]
  double run_step_ratio = 0;           ///< c, in [1e-3, 5]
};

/// The keys that `fretting --print-keys` lists, each checked against its listed range.
FrettingParameters read_fretting(Scene& scene);

/// Tables: loops (force and displacement), cycles (each with its errors), errors (against N),
/// orders, curve (dissipation against the amplitude), lengths (the same for each L0), run (energies
/// on the way), claims.
std::vector<Table> fretting(const FrettingParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
