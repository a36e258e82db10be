// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How do schemes behave at extreme parameters? One or two parameters at a time go to their
/// extremes; all others keep their ordinary values.
struct ExtremesParameters {
  Material material;
  HertzBound bound;
  double length = 0;          ///< L0 of plane strain  [mm]
  Eigen::Index elements = 0;  ///< N; odd, for quadratic functions and fractional powers
  double stick_ratio = 0;     ///< a'  [1]

  /// Limits beyond which a result counts as failed.
  struct Limits {
    double error = 0;       ///< of force or creepage, relative  [1]
    double wiggle = 0;      ///< amplitude over the peak of the bound  [1]
    double operations = 0;  ///< of one case; a case that is expected to take more is not run
  } limits{};

  std::vector<double> step_ratios{};        ///< c of steady rolling  [1]
  std::vector<Eigen::Index> sizes{};        ///< N of steady rolling
  std::vector<double> large_step_ratios{};  ///< c with large N  [1]
  std::vector<Eigen::Index> large_sizes{};  ///< N that are run at any cost
  std::vector<double> strip_widths{};       ///< over dx  [1]
  std::vector<double> poisson_ratios{};     ///< of strips  [1]
  std::vector<double> stick_ratios{};       ///< a' of small loads  [1]
  std::vector<double> sliding{};            ///< 1 - a' of large loads  [1]
  std::vector<double> bound_loads{};        ///< forces over full sliding, bounds not smooth  [1]
  std::vector<double> layers{};             ///< compliances over 2 (1 - nu) a/G  [1]
  std::vector<double> strains{};            ///< beta/mu of bodies of different material  [1]
  std::vector<double> kernel_loads{};       ///< forces over full sliding of both  [1]
  std::vector<double> offsets{};            ///< of either edge from its node  [dx]
  std::vector<double> transient_ratios{};   ///< c of a transient  [1]
  std::vector<Eigen::Index> transient_sizes{};  ///< N of a transient
  double distance = 0;                          ///< rolled, or as far as most_steps go  [dx]
  Eigen::Index most_steps = 0;                  ///< of a transient
  std::vector<double> endurance_ratios{};       ///< c of very many steps  [1]
  std::vector<Eigen::Index> states{};           ///< steps after which the state is taken, ascending
  std::vector<double> slope_ratios{};     ///< slope force of a cylinder over full sliding  [1]
  std::vector<double> cylinder_ratios{};  ///< c of a cylinder  [1]
  std::vector<double> scales{};           ///< factors of G, a and mu p0  [1]
};

/// The keys that `extremes --print-keys` lists, each checked against its listed range.
ExtremesParameters read_extremes(Scene& scene);

/// Tables: steps (c and N of steady rolling), widths (strip width and Poisson ratio), loads (from
/// full stick to full sliding), bounds (that are not smooth), kernels (layers of springs), bodies
/// (of different material), offsets (of both edges), transient (c and N), endurance (many steps),
/// cylinder (slope and c), each with one row per case, failures included; scales (errors of scale
/// invariance); ranges (safe ranges of each scheme) and claims.
std::vector<Table> extremes(const ExtremesParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
