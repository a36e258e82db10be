// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/straight_steps.hpp"
#include "microslip/rolling/transient_problem.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// A history of more rows would take more than 300 MB.
inline constexpr double most_steps = 1e6;

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
