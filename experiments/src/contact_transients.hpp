// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "microslip/patch/standard_patch.hpp"

namespace microslip::experiments {

/// Results of CONTACT v25.2 (open source; run for this project, T = 2, the solver TangCG to 1e-7) on
/// the circle of contact_rectangles() with 20 elements a diameter: a shift by a force of 0.6 of full
/// sliding, then rolling under the same force in steps of c elements.
struct ContactTransient {
  double step_ratio;
  std::array<double, 3> creepage;  ///< of the steps that end at q = 0.5, 1, 1.5 mm
  /// At q = 1.5 mm in the row y = 0.05 mm, from the trailing edge on  [N/mm^2]
  std::array<double, 20> traction;
};

inline constexpr std::array<double, 3> contact_distances{0.5, 1, 1.5};
inline constexpr double contact_force = 0.6;  ///< over full sliding

std::span<const ContactTransient> contact_transients();

}  // namespace microslip::experiments
