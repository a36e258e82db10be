// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// The steps of a run, as for_steps() takes them.
struct RunSteps {
  double distance;                     ///< at the end  [mm]
  const std::vector<double>& lengths;  ///< dq, taken in turn  [mm]
  double from;                         ///< distance at the start  [mm]
  const std::vector<double>& ends;     ///< distances at which a step has to end  [mm]
};

/// Reads motion.instants or motion.instants_at: the ends of steps that are nearest to the places
/// where tractions are wanted. Warns if several places have one end.
/// \return numbers of steps, rising; 0 is the start; none without these keys
/// \throws std::invalid_argument for numbers out of range, and for places that do not rise or lie
///         outside of the run
std::vector<std::size_t> read_instants(Scene& scene, const RunSteps& steps);

}  // namespace microslip
