// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/steady.hpp"

namespace microslip {

/// Steady rolling without a word about how it is solved.
struct SteadyContact {
  Kernel kernel;
  TractionBound bound;
  Load load;
};

/// A solution and how far it is from the exact one.
struct EstimatedSteady {
  SteadyProblem problem;  ///< with the method, the basis and the grid that were picked
  SteadySolution solution;
  Eigen::Index unknowns;  ///< of its systems
  /// Estimate of the relative error of what is not prescribed, the creepage or the force. Meant to
  /// be an upper limit of the right size: tests/unit/target_error_test.cpp  [1]
  double error;
};

/// Largest and least error that may be asked for.
inline constexpr double coarsest_target = 0.1;
inline constexpr double finest_target = 1e-11;

/// \throws std::invalid_argument outside them
void require_target_error(double target);

/// By what is cheapest in the study speed_accuracy: Chebyshev collocation where the bound is
/// smooth, the strip wide enough and one zone sticks; else as estimate_by_elements(). \param target
/// in [1e-11, 0.1]  [1] \throws std::invalid_argument for loads and targets out of their ranges
/// \throws NotConverged          if the target is not reached
EstimatedSteady solve_steady_to(const SteadyContact& contact, double target);

/// Calibrated constant elements, the number of which grows until the estimate is below the target.
/// Estimate: half the difference to a solution by half as many elements, where second order says a
/// third; all of it where there is more than one stick zone, and convergence less even.
/// \throws as solve_steady_to
EstimatedSteady estimate_by_elements(const SteadyContact& contact, double target);

}  // namespace microslip
