// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// A wheel under a constant creepage and an oscillating normal load, P = P0 (1 + amplitude sin(2 pi
/// q/L)), in plane strain. Half-width and bound follow the current load by Hertz's theory.
struct VaryingLoadParameters {
  Material material;
  HertzBound bound;                    ///< under the mean load P0
  double length = 0;                   ///< L0  [mm]
  std::vector<double> stick_ratios{};  ///< a' of Carter's solution under the mean load
  std::vector<double> wavelengths{};   ///< L/a, at which small waves are rolled, rising
  double amplitude = 0;                ///< of small waves
  int alignments = 0;                  ///< of the stick-slip point in an element, 1 to 20
  std::vector<Eigen::Index> sizes{};   ///< N, rising
  std::vector<double> step_ratios{};   ///< c; the first is 1
  double large_amplitude = 0;          ///< of large waves, below 1
  double large_stick_ratio = 0;        ///< a' of the mean state of large waves
  std::vector<double> shown{};         ///< L/a of the large waves whose force is shown
  double shortest = 0, longest = 0;    ///< of curves, L/a
  int points = 0;                      ///< of curves
};

/// The keys that `varying_load --print-keys` lists, each checked against its listed range.
VaryingLoadParameters read_varying_load(Scene& scene);

/// Tables: curves (exact response to small waves, Carter's solution under the current load,
/// springs), measured (small waves by the scheme), orders, waves (the force along a large wave),
/// means (over large waves, against their length), claims.
std::vector<Table> varying_load(const VaryingLoadParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
