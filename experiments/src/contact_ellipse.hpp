// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "microslip/patch/standard_patch.hpp"
#include "microslip/patch/steady_patch.hpp"

namespace microslip::experiments {

/// The force in the direction of the creepage, for spin the lateral one, and the moment.
struct ContactResult {
  double force;   ///< [N]
  double moment;  ///< about the centre  [N mm]
};

/// Results of CONTACT v25.2 (open source; run for this project with its defaults but the solver
/// GDsteady, tolerances 1e-7 and 1e-8) on a circle of the radius 1 mm with G = 1, nu = 0.28,
/// mu = 0.3 and Fn = 1 N, which is mu p0 = 0.45/pi. Steady rolling over steps of one element.
struct ContactState {
  const char* kind;                      ///< longitudinal, lateral or spin
  double level;                          ///< creepage over 0.07, 0.08 or 0.2/mm
  std::array<ContactResult, 3> results;  ///< on 20, 28 and 40 elements a diameter
  ContactResult limit;  ///< extrapolated from 28 to 160 elements a diameter; to about 5e-4 of mu Fn
};

inline constexpr std::array<Eigen::Index, 3> contact_diameters{20, 28, 40};
inline constexpr std::array<Eigen::Index, 3> contact_elements{316, 624, 1272};

std::span<const ContactState> contact_states();

/// The same state with joined rows.
SteadyPatch patch_of(const ContactState& state, Eigen::Index rows, Eigen::Index elements);

/// The circle of these states with equal rectangles, as many across as along.
StandardPatch contact_rectangles(Eigen::Index elements);

}  // namespace microslip::experiments
