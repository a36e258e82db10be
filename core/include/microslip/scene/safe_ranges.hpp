// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/halfspace/basis.hpp"
#include "microslip/rolling/advection.hpp"

namespace microslip {

/// \file
/// Where a scheme is safe: the force, the creepage and the tractions of the study `extremes` are
/// within 10 % there, and no wave from node to node exceeds 1 % of the peak of the bound. Measured;
/// tests/study/extremes_test.cpp holds them against the study. Outside, a scene is solved as it was
/// asked for, with a warning.

/// A closed interval.
struct SafeRange {
  double least;
  double most;  ///< inf if there is none

  bool holds(double value) const { return value >= least && value <= most; }
};

/// c of steady differences: below they wiggle, above they are too coarse  [1]
inline constexpr SafeRange safe_difference{0.7, 1.5};

/// N of steady differences, by the order of the functions  [1]
SafeRange safe_elements(const Basis& basis);

/// c of a transient: below, tractions wiggle or are smeared; above, steps are too coarse. On a grid
/// that is fixed to the material, any.
SafeRange safe_steps(const AdvectionScheme& scheme);

/// c of a transient under a force, of 5 % of full sliding or more, from which on rounding leaves 1
/// % of the creepage or less: that is a shift over the length of a step, and the shift has the
/// rounding of the displacements. On a grid that is fixed to the material those of the bound are
/// among them, and nodes enter to 1e-9 of an element. tests/unit/small_steps_test.cpp  [1]
double least_step_under_force(const AdvectionScheme& scheme, Eigen::Index elements);

}  // namespace microslip
