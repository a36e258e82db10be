// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Friction that falls with slip in a line contact and an ellipse of steel: what of several solutions,
/// of peaks that travel, and of results that depend on the step is left where the step does not
/// matter?
struct FallingFrictionParameters {
  double shear_modulus = 0;               ///< [N/mm^2]
  double poisson_ratio = 0;               ///< [1]
  double half_width = 0;                  ///< [mm]
  double peak_traction = 0;               ///< at rest  [N/mm^2]
  double kinetic_ratio = 0;               ///< of the exponential law  [1]
  double half_speed = 0;                  ///< of the law  [mm/s]
  double length = 0;                      ///< L0 of plane strain  [mm]
  double creepage = 0;                    ///< w < 0  [1]
  double speed = 0;                       ///< V  [mm/s]
  double change = 0;                      ///< of the creepage before single steps, relative  [1]
  std::vector<Eigen::Index> elements{};   ///< N of steady rolling, rising
  std::vector<double> steady_memories{};  ///< d, rising  [mm]
  std::vector<double> curve_speeds{};     ///< V  [mm/s]
  Eigen::Index curve_points = 0;
  double largest_creepage = 0;             ///< of the curve
  Eigen::Index step_elements = 0;          ///< N of single steps
  std::vector<double> step_lengths{};      ///< dq of single steps, falling  [mm]
  Eigen::Index run_elements = 0;           ///< N of runs
  double run_distance = 0;                 ///< [mm]
  std::vector<double> step_ratios{};       ///< c of runs, falling
  std::vector<double> memories{};          ///< d of runs, rising  [mm]
  double shown = 0;                        ///< q of the tractions in figures  [mm]
  double lateral_half_width = 0;           ///< of the ellipse  [mm]
  Eigen::Index ellipse_rows = 0;           ///< M
  Eigen::Index ellipse_elements = 0;       ///< N of each row
  double ellipse_distance = 0;             ///< of its runs  [mm]
  std::vector<double> ellipse_memories{};  ///< d of these, rising  [mm]
};

/// The keys that `falling_friction --print-keys` lists, each checked against its listed range.
FallingFrictionParameters read_falling_friction(Scene& scene);

/// Tables: steady (forces against N), curve (forces against the creepage), steps (single steps from
/// steady rolling, of both branches), runs (forces against the step), limits (where linear theory
/// puts the ends of unique solutions), tractions (of runs), contact (CONTACT's example), ellipse
/// (runs of a contact ellipse), claims.
std::vector<Table> falling_friction(const FallingFrictionParameters& parameters,
                                    const Progress& progress);

}  // namespace microslip::experiments
