// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/dynamics/cylinder.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Runs that double N until the next one is expected to take more operations than this.
struct WorkLimit {
  double operations;  ///< of a run, see microslip/support/work.hpp
};

/// Measures the cost of a given accuracy for each scheme, basis, edge treatment, step ratio and
/// solver, all with the same list of N.
struct SpeedAccuracyParameters {
  PolynomialBound bound;  ///< of steady rolling; not Hertzian, because calibration is exact for the
                          ///< Hertzian bound
  Material material;
  double length;                    ///< L0 of plane strain  [mm]
  double width;                     ///< of the strip  [mm]
  std::vector<Eigen::Index> sizes;  ///< N: odd multiples of three
  double repeats;                   ///< runs are repeated until they have taken this time together
                                    ///< [s]

  /// Steady rolling.
  struct Steady {
    WorkLimit limit;
    std::vector<double> stick_ratios;    ///< a' of the loads; the errors are the largest over them
    std::vector<double> step_ratios;     ///< c of differences in plane strain
    std::vector<Eigen::Index> unknowns;  ///< of Chebyshev collocation
  } steady;

  /// Cattaneo to Carter over a third of the contact, N/3 elements: 50 for N = 150.
  struct Transient {
    WorkLimit limit;
    HertzBound bound;
    double force;  ///< [N/mm]
    std::vector<double> step_ratios;
    Eigen::Index reference;  ///< N of the reference, which is remembered with c = 1
  } transient;

  /// The cylinder.
  struct Rolling {
    WorkLimit limit;
    Cylinder cylinder;
    double length;    ///< L0  [mm]
    double distance;  ///< from rest  [mm]
    std::vector<double> step_ratios;
    Eigen::Index reference;  ///< N of the reference for the motion, which is remembered with Verlet
  } rolling;

  /// Steady rolling under bounds that are rough at all scales, see Roughness.
  struct Rough {
    std::vector<double> hursts;
    double amplitude;
    unsigned seed;
    Eigen::Index rows;
    double force_ratio;
    std::vector<Eigen::Index> sizes;
    Eigen::Index reference;  ///< N of the solution that is taken as exact
  } rough;
};

/// The keys that `speed_accuracy --print-keys` lists, each checked against its listed range.
SpeedAccuracyParameters read_speed_accuracy(Scene& scene);

/// Tables: runs (errors and work of all runs, failures included), fronts (Pareto-optimal runs in
/// error and work, among all and of each scheme), cheapest (run within each accuracy, beside the
/// thesis's), rough (errors against N under rough bounds), claims; and with measured times
/// runs_timing, fronts_timing, cheapest_timing.
std::vector<Table> speed_accuracy(const SpeedAccuracyParameters& parameters,
                                  const Progress& progress);

}  // namespace microslip::experiments
