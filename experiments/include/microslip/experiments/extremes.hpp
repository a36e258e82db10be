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
  double length;          ///< L0 of plane strain  [mm]
  Eigen::Index elements;  ///< N; odd, for quadratic functions and fractional powers
  double stick_ratio;     ///< a'  [1]

  /// Limits beyond which a result counts as failed.
  struct Limits {
    double error;       ///< of force or creepage, relative  [1]
    double wiggle;      ///< amplitude over the peak of the bound  [1]
    double operations;  ///< of one case; a case that is expected to take more is not run
  } limits;

  struct {
    std::vector<double> ratios;  ///< c  [1]
    std::vector<Eigen::Index> sizes;
    std::vector<double> ratios_of_large;
    std::vector<Eigen::Index> large;  ///< sizes that are run at any cost
  } steps;

  struct {
    std::vector<double> ratios;  ///< strip width over dx  [1]
    std::vector<double> poisson_ratios;
  } widths;

  struct {
    std::vector<double> stuck;    ///< a'  [1]
    std::vector<double> sliding;  ///< 1 - a'  [1]
  } loads;

  std::vector<double> bounds;  ///< forces over full sliding, under bounds that are not smooth  [1]

  struct {
    std::vector<double> layers;   ///< compliance of a layer of springs over 2 (1 - nu) a/G  [1]
    std::vector<double> strains;  ///< beta/mu of bodies of different material  [1]
    std::vector<double> loads;    ///< forces over full sliding of both  [1]
  } kernels;

  std::vector<double> offsets;  ///< of either edge from its node  [dx]

  struct {
    std::vector<double> ratios;  ///< c  [1]
    std::vector<Eigen::Index> sizes;
    double distance;  ///< rolled, or as far as most_steps go  [dx]
    Eigen::Index most_steps;
  } transient;

  struct {
    std::vector<double> ratios;        ///< c  [1]
    std::vector<Eigen::Index> states;  ///< steps after which the state is taken, ascending
  } endurance;

  struct {
    std::vector<double> force_ratios;  ///< slope force over full sliding  [1]
    std::vector<double> ratios;        ///< c  [1]
  } cylinder;

  std::vector<double> scales;  ///< factors of G, a and mu p0, one at a time and all at once  [1]
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
