// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/dynamics/cylinder.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How exact is the energy balance of a cylinder that starts to roll down a slope? Thesis chapter
/// 9.
struct EnergyBalanceParameters {
  CylinderScene scene;              ///< of the motion shown; its scheme and integrator are not used
  std::vector<double> snapshots{};  ///< positions of the tractions shown, ascending  [mm]
  std::vector<Eigen::Index> sizes{};         ///< N of the energy errors, each twice its predecessor
  double error_distance = 0;                 ///< at which errors are taken  [mm]
  std::vector<Eigen::Index> motion_sizes{};  ///< N whose motion is compared with a finer one
  Eigen::Index refinement = 0;               ///< elements of the finer one over the last N, >= 2
  std::vector<double> step_ratios{};         ///< c of equal steps beside a tolerance, falling
  std::vector<double> tolerances{};          ///< motion.tolerance, with the first c  [1]
};

/// The keys that `energy_balance --print-keys` lists, each checked against its listed range.
EnergyBalanceParameters read_energy_balance(Scene& scene);

/// Tables: motion (v and omega R against X), snapshots, energy (all energies and sums against X),
/// energy_error (against N for each frame, integrator and ledger), motion_error (against a finer
/// run), step_control (steps by tolerance, and equal steps), orders, claims.
std::vector<Table> energy_balance(const EnergyBalanceParameters& parameters,
                                  const Progress& progress);

}  // namespace microslip::experiments
