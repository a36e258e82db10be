// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/dynamics/cylinder.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Measures the cost of a given accuracy for each scheme, basis, edge treatment, step ratio and
/// solver, all with the same list of N.
struct SpeedAccuracyParameters {
  PolynomialBound bound;  ///< of steady rolling; not Hertzian, because calibration is exact for the
                          ///< Hertzian bound
  Material material;
  HertzBound hertz;                   ///< of transients
  double length = 0;                  ///< L0 of plane strain  [mm]
  double width = 0;                   ///< of the strip  [mm]
  std::vector<Eigen::Index> sizes{};  ///< N: odd multiples of three
  double repeats = 0;                 ///< runs are repeated until they took so long together  [s]

  // Steady rolling. Operations are those of a run, see microslip/support/work.hpp.
  double steady_operations = 0;
  std::vector<double> stick_ratios{};    ///< a' of the loads; the errors are the largest over them
  std::vector<double> step_ratios{};     ///< c of differences in plane strain
  std::vector<Eigen::Index> unknowns{};  ///< of Chebyshev collocation

  // Cattaneo to Carter over a third of the contact, N/3 elements: 50 for N = 150.
  double transient_operations = 0;
  double force = 0;                        ///< [N/mm]
  std::vector<double> transient_ratios{};  ///< c
  Eigen::Index transient_reference = 0;    ///< N of the reference, which is remembered with c = 1

  double cylinder_operations = 0;
  Cylinder cylinder{};
  double cylinder_length = 0;             ///< L0  [mm]
  double distance = 0;                    ///< from rest  [mm]
  std::vector<double> cylinder_ratios{};  ///< c
  Eigen::Index cylinder_reference = 0;    ///< N of the reference, remembered with Verlet

  // Steady rolling under bounds that are rough at all scales, see Roughness.
  std::vector<double> hursts{};
  double roughness = 0;  ///< root of its mean square over the bound
  unsigned seed = 0;
  Eigen::Index rough_rows = 0;
  double rough_load = 0;                    ///< force over full sliding
  std::vector<Eigen::Index> rough_sizes{};  ///< N
  Eigen::Index rough_reference = 0;         ///< N of the solution that is taken as exact
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
