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

/// Steady rolling of bodies of different material in plane strain, under Hertz's bound. All that
/// matters are beta/mu and the force over full sliding.
struct UnlikeBodiesParameters {
  Material material;  ///< combined constants
  HertzBound bound;
  Eigen::Index elements = 0;          ///< N of curves and zones
  double smallest = 0, largest = 0;   ///< beta/mu of free rolling
  int free_points = 0;                ///< evenly spaced in its logarithm
  std::vector<double> ratios{};       ///< beta/mu of tractive rolling
  double zones_ratio = 0;             ///< beta/mu of the zones of tractive rolling, and of errors
  int tractive_points = 0;            ///< forces
  std::vector<Eigen::Index> sizes{};  ///< N of errors, rising
};

/// The keys that `unlike_bodies --print-keys` lists, each held to what that says it accepts.
UnlikeBodiesParameters read_unlike_bodies(Scene& scene);

/// Tables: free (creepage of free rolling), tractive (creepage against the force), zones, errors,
/// orders, claims.
std::vector<Table> unlike_bodies(const UnlikeBodiesParameters& parameters,
                                 const Progress& progress);

}  // namespace microslip::experiments
