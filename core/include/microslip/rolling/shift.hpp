// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <variant>

#include "microslip/friction/active_set.hpp"

namespace microslip {

/// A rigid shift without rolling. A positive one gives negative tractions, as creepage does.
struct PrescribedShift {
  double value;  ///< finite  [mm]
};

/// The end of a shift: how far, or until which force.
using ShiftLoad = std::variant<PrescribedShift, PrescribedForce>;

/// The result of a shift without rolling. The equation of its slip is s = shift + A (p - p'), with
/// the tractions p' before and p after it, and the slip as displacement.
struct Shift {
  double distance = 0;   ///< rigid shift, prescribed or found  [mm]
  Eigen::VectorXd slip;  ///< at the nodes, by A p alone  [mm]

  // Energies per mm width, on the way of a force that rises or falls steadily: where bodies slip,
  // they do so at the bound, -p s, from when it is reached. So a shift in parts has the same sum:
  // to rounding with Direct; with Remembered to 6e-3 of the work at N = 41.
  // tests/unit/shift_test.cpp
  double dissipation = 0;  ///< [N]
  double work = 0;  ///< of the force, -integral of F d(shift): dissipation plus the change of
                    ///< elastic_energy(), to rounding where basis functions are equal  [N]
};

}  // namespace microslip
