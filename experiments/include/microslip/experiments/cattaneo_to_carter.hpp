// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/transient.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip::experiments {

/// The thesis's transient case: a Cattaneo shift under a force, which rolling then turns to
/// Carter's solution. Thesis 4, 7 and 8, CONTACT's example 5.8 in 2D.
struct CattaneoToCarter {
  Kernel kernel;
  HertzBound bound;
  Grid grid;  ///< filling the contact
  Basis basis;
  double force;  ///< less in absolute value than full sliding  [N/mm]
  Solver solver = {};

  TransientProblem problem(const AdvectionScheme& scheme) const;

  /// Rolled from the shift.
  /// \param elements    distance, in elements
  /// \param step_ratio  c of all steps but the last, which ends at the distance
  TransientRolling rolled(const AdvectionScheme& scheme, double step_ratio, double elements) const;

  /// The same distance on a grid of `refinement` elements for each one, with c = 1 there.
  TransientRolling refined(double elements, Eigen::Index refinement) const;
};

/// material.*, kernel.*, contact.*, grid.elements (filling the contact), basis, load.force
CattaneoToCarter read_cattaneo_to_carter(Scene& scene);

}  // namespace microslip::experiments
