// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How does the step ratio affect the solution of the Carter-Fromm problem? Thesis Fig. 1.1.
struct CarterParameters {
  SteadyProblem problem;  ///< with a Hertzian bound; by differences, with each of the next
  std::vector<double> step_ratios;  ///< c of the tractions shown, falling, each >= 1e-15  [1]
  std::vector<double> accuracy_step_ratios;  ///< c of the force errors, likewise  [1]
};

/// The keys that `carter --print-keys` lists, each checked against its listed range.
CarterParameters read_carter(Scene& scene);

/// Tables: traction (one row per node and step ratio, with the exact solution), exact (the exact
/// solution at many points), summary (one row per step ratio: errors and number of wiggles),
/// accuracy (force error against c) and claims.
/// \throws NotConverged as solve_steady
std::vector<Table> carter(const CarterParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
