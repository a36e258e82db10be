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

/// Rolling on a half-space in plane strain, on the same with layers of springs, and on springs
/// alone, under Hertz's bound. A layer's softness is its compliance C over 2 (1 - nu)/G a, the
/// compliance of the half-space to waves of 2 pi a.
struct KernelsParameters {
  Material material;
  HertzBound bound;
  double length = 0;                  ///< L0 of plane strain  [mm]
  std::vector<double> softness{};     ///< of the layers, rising  [1]
  Eigen::Index elements = 0;          ///< N of curves and transients
  int points = 0;                     ///< creepages of a curve
  Eigen::Index noise_elements = 0;    ///< least N of wiggles
  double noise_step = 0;              ///< least c of wiggles
  int noise_points = 0;               ///< evenly spaced in its logarithm up to 1
  int edge_points = 0;                ///< compliances of which the edge is measured
  double force_ratio = 0;             ///< of wiggles, errors and transients
  std::vector<Eigen::Index> sizes{};  ///< N of errors, rising
};

/// The keys that `kernels --print-keys` lists, each held to what that says it accepts.
KernelsParameters read_kernels(Scene& scene);

/// Tables: curves, slopes, noise, edges, errors, orders, transients, claims.
std::vector<Table> kernels(const KernelsParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
