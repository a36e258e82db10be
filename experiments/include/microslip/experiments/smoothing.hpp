// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How does a traction peak change that travels in steps that are not whole numbers of elements?
/// Thesis chapter 4, for the direct scheme with constant and linear functions.
struct SmoothingParameters {
  CattaneoToCarter rolling;           ///< its kernel and spacing are used for the pulse, too
  std::vector<double> step_ratios{};  ///< c, each >= 1e-15; the first is a whole number  [1]
  double distance = 0;                ///< of Figs. 4.2 and 4.3, in elements
  Eigen::Index pulse_elements = 0;    ///< size of A^-1 A', odd; the pulse starts in the middle
  Eigen::Index frequencies = 0;       ///< of the amplification factor, in [8, 1000]
  Eigen::Index refinement = 0;        ///< elements of the reference for each element, >= 2
};

/// The keys that `smoothing --print-keys` lists, each checked against its listed range.
SmoothingParameters read_smoothing(Scene& scene);

/// Tables: pulse (A^-1 A' on a unit pulse after one step and after the distance, Figs. 4.1, 4.2),
/// pulse_summary (sum, peak, width, total variation), amplification (damping and speed against
/// frequency), traction and reference (Cattaneo to Carter, Fig. 4.3), summary (its peaks and
/// errors), claims.
std::vector<Table> smoothing(const SmoothingParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
