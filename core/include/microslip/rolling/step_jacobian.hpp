// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// Derivatives of a step's results by one of its inputs. The unit of each is the result's unit,
/// given here, over the input's unit.
struct StepSlopes {
  double force = 0;        ///< of F at the end of the step  [N/mm]
  double mean_force = 0;   ///< of the mean of F over the step  [N/mm]
  double creepage = 0;     ///< of w  [1]
  double dissipation = 0;  ///< of the energy lost per mm rolled and mm width  [N/mm]
};

/// Derivatives of a discrete step from a given state. The partition is held fixed, and the
/// stick-slip point moves as in the scheme, so that derivatives are exact wherever the partition
/// does not change. Where the partition changes, or the step ends with a whole element, they are
/// one-sided.
struct StepJacobian {
  StepSlopes by_load;    ///< by the creepage w [1] or the force F [N/mm], whichever is prescribed
  StepSlopes by_length;  ///< by dq at that load  [mm]
};

}  // namespace microslip
