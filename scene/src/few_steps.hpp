// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/straight_steps.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

/// A history of more rows would take more than 300 MB.
inline constexpr double most_steps = 1e6;

/// Refuses too many steps.
/// \param from     where they begin  [mm]
/// \param length   of a step, in the mean  [mm]
/// \param instead  called without arguments; ways out, behind the message
template <class Instead>
void require_few_steps(double distance, double from, double length, const Instead& instead) {
  const double steps = std::ceil((distance - from) / length);
  require(steps <= most_steps, "motion.distance", distance, [&] {
    return "at most " + format_short(most_steps) + " steps, not " + format_short(steps) + instead();
  });
}

/// Reads step.ratio, one or more numbers; those of steps of length 0, in which nothing happens, are
/// left out.
std::vector<double> read_step_ratios(Scene& scene);

/// Reads motion.distance.
/// \param of_file  distance of load.file, and the default; infinite without the file  [mm]
/// \param from     where the run starts  [mm]
double read_distance(Scene& scene, double of_file, double from);

/// The tolerance of steps of a load from row to row: `part` of full sliding, or of the problem's
/// contact.
LoadTolerance tolerance_of_load(const TransientProblem& problem, double part);

/// Ways out of too many steps, for the end of a message: longer steps, or none at all where the
/// load changes over many contact lengths. Empty for a load that does not change.
std::string instead_of_many_steps(const TransientProblem& problem, const LoadHistory& loads,
                                  bool has_tolerance);

/// Refuses a run of load.file with a step for each row, and too many rows.
void require_few_rows(const Scene& scene, const TransientProblem& problem,
                      const LoadHistory& loads);

}  // namespace microslip
