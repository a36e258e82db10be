// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/friction/load.hpp"

namespace microslip {

/// The result of a shift without rolling. The slip displacement is s = shift + A (p - p'), with the
/// tractions p' before and p after the shift.
struct Shift {
  double distance = 0;   ///< rigid shift, prescribed or found  [mm]
  Eigen::VectorXd slip;  ///< at the nodes, from A p alone  [mm]

  // Energies per mm width, along a force that rises or falls monotonically: bodies that slip
  // dissipate -p s with p at the bound, from the moment when p reaches the bound. So the energies
  // of a shift in several steps have the same sum: to rounding with Direct; with Remembered to 6e-3
  // of the work at N = 41. tests/unit/shift_test.cpp
  double dissipation = 0;  ///< [N]
  double work = 0;  ///< of the force, -integral of F d(shift). It equals dissipation plus the
                    ///< change of elastic_energy(), to rounding if basis functions are equal  [N]
};

}  // namespace microslip
