// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// Derivatives of the results of a step by one of its inputs; units are those of the result over
/// those of the input.
struct StepSlopes {
  double force = 0;        ///< of F at the end of the step  [N/mm]
  double mean_force = 0;   ///< of the mean of F over the step  [N/mm]
  double creepage = 0;     ///< of w  [1]
  double dissipation = 0;  ///< of the energy lost per mm rolled and mm width  [N/mm]
};

/// Derivatives of a discrete step from a given state. The partition stays as it is, and the
/// stick-slip point moves as the scheme has it: they are exact wherever the partition does not
/// change. Where it does, and where the step ends with a whole element, they are those of one side.
struct StepJacobian {
  StepSlopes by_load;    ///< by the creepage w [1] or the force F [N/mm], as the load prescribes
  StepSlopes by_length;  ///< by dq at that load  [mm]
};

}  // namespace microslip
