// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/transient.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip::experiments {

/// The thesis's transient case: a Cattaneo shift under a force, followed by rolling to Carter's
/// solution. Thesis 4, 7 and 8, CONTACT's example 5.8 in 2D.
struct CattaneoToCarter {
  Kernel kernel;
  HertzBound bound;
  Grid grid;  ///< filling the contact
  Basis basis;
  double force;  ///< less in absolute value than full sliding  [N/mm]
  Solver solver = {};

  TransientProblem problem(const AdvectionScheme& scheme) const;

  /// The contact after rolling from the shift.
  /// \param elements    distance, in elements
  /// \param step_ratio  c of all steps except for the last, which ends at the distance
  TransientRolling rolled(const AdvectionScheme& scheme, double step_ratio, double elements) const;

  /// The same distance on a grid with `refinement` elements for each element, with c = 1 on that
  /// grid.
  TransientRolling refined(double elements, Eigen::Index refinement) const;
};

/// material.*, kernel.*, contact.*, grid.elements (filling the contact), basis, load.force
CattaneoToCarter read_cattaneo_to_carter(Scene& scene);

}  // namespace microslip::experiments
