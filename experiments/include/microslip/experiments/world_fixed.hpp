// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Which artefacts does a grid have that is fixed to the material, thesis 9 and 11? The study shows
/// the creepage under a constant force, from a Cattaneo shift to Carter's solution, for three
/// treatments of the elements at the edges of the contact, and for the direct scheme.
struct WorldFixedParameters {
  CattaneoToCarter rolling;  ///< with the grid of the creepage shown and of the errors
  double step_ratio = 0;     ///< c of the creepage shown, in (0, 0.5]
  double shown = 0;          ///< end of the way on which the creepage is shown  [elements]
  double part = 0;           ///< of an element, by which the contact is longer then
  double distance = 0;       ///< rolled when the noise is measured, in half-widths, > 0
  std::vector<Eigen::Index> elements{};     ///< N of the noise against N, rising
  Eigen::Index largest_cut = 0;             ///< largest N of cut elements, whose steps cost O(N^3)
  double noise_step_ratio = 0;              ///< c of the noise against N, in (0, 0.5]
  Eigen::Index noise_elements = 0;          ///< N of the noise against c
  std::vector<double> step_ratios{};        ///< c of the noise against c, each in [1e-3, 1]
  std::vector<double> error_step_ratios{};  ///< c of the errors, each in [1e-3, 1]
  Eigen::Index error_distance = 0;  ///< rolled when the errors are measured, in elements, > 0
  Eigen::Index refinement = 0;      ///< elements of the reference for each element, >= 2
};

/// The keys that `world_fixed --print-keys` lists, each checked against its listed range.
WorldFixedParameters read_world_fixed(Scene& scene);

/// Tables: creepage (step by step), events (jumps of the creepage, by the cause in the step), noise
/// (against N and c), errors (of the traction), orders, claims.
std::vector<Table> world_fixed(const WorldFixedParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
