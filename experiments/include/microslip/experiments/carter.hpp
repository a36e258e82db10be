// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// What does the step ratio do to the Carter-Fromm problem? Thesis Fig. 1.1.
struct CarterParameters {
  SteadyProblem problem;  ///< with a Hertzian bound; by differences, with each of the next
  std::vector<double> step_ratios;  ///< c of the tractions shown, falling, each >= 1e-15  [1]
  std::vector<double> accuracy_step_ratios;  ///< c of the force errors, likewise  [1]
};

/// The keys that `carter --print-keys` lists, each held to what that says it accepts.
CarterParameters read_carter(Scene& scene);

/// Tables: traction (a row a node and step ratio, with the exact solution), exact (a fine line),
/// summary (a row a step ratio: errors and the count of wiggles), accuracy (the force error against
/// c) and claims.
/// \throws NotConverged as solve_steady
std::vector<Table> carter(const CarterParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
