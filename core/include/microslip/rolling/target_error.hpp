// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// The problem of the contact on a grid that fills it, with constant functions.
/// \param elements  N, in [1, 4e6]
SteadyProblem problem_of(const SteadyContact& contact, Eigen::Index elements,
                         const SteadyMethod& method);

/// A solution and an estimate of its error.
struct EstimatedSteady {
  SteadyProblem problem;  ///< with the chosen method, basis and grid
  SteadySolution solution;
  Eigen::Index unknowns;  ///< number, in the systems of equations; 0 without a system
  /// Estimate of the relative error of the creepage or the force, whichever is not prescribed. It
  /// is meant as an upper limit of the right size: tests/unit/target_error_test.cpp  [1]
  double error;
};

/// Largest and smallest accepted target.
inline constexpr double coarsest_target = 0.1;
inline constexpr double finest_target = 1e-11;

/// \throws std::invalid_argument outside these limits
void require_target_error(double target);

/// Solves by inversion if there is one stick zone, otherwise as estimate_by_elements().
///
/// \param target  in [1e-11, 0.1]  [1]
/// \throws std::invalid_argument for loads or targets out of their ranges
/// \throws NotConverged          if the target is not reached
EstimatedSteady solve_steady_to(const SteadyContact& contact, double target);

/// Solves with constant elements over the whole contact. Their number grows until the estimate is
/// below the target. The estimate is the sum of two terms: the difference to solutions with fewer
/// elements, and the effect of violated contact conditions.
/// tests/property/generated_contacts_test.cpp counts how often the estimate holds.
/// \throws as solve_steady_to
EstimatedSteady estimate_by_elements(const SteadyContact& contact, double target);

}  // namespace microslip
