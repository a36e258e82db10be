// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How much do short steps of a contact ellipse wiggle, smear and drift? The thesis's Figs. 7.1, 7.2
/// and 8.3 in three dimensions, on the circle for which CONTACT was run.
struct EllipseWigglesParameters {
  Eigen::Index elements = 0;                ///< N, of both schemes
  Eigen::Index rows = 0;                    ///< M of joined rows; the standard scheme has N
  std::vector<double> step_ratios{};        ///< c, falling, under a creepage after the shift
  std::vector<double> force_step_ratios{};  ///< c, falling, under a held force after the shift
  std::vector<double> spin_step_ratios{};   ///< c, falling, under spin from rest
  double creepage = 0;                      ///< after the shift
  double spin = 0;                          ///< from rest  [1/mm]
  std::vector<double> distances{};          ///< q over the half-width, rising
  double shown = 0;                         ///< q of the tractions of figures, one of these
  Eigen::Index reference_rows = 0;          ///< M of the reference
  Eigen::Index reference_elements = 0;      ///< N of the reference
  double reference_step_ratio = 0;          ///< c of the reference
  Eigen::Index map_rows = 0;                ///< M of the map of tractions under spin, by c = 1
  std::vector<double> map_distances{};      ///< q over the half-width, rising
};

/// The keys that `ellipse_wiggles --print-keys` lists, each checked against its listed range.
EllipseWigglesParameters read_ellipse_wiggles(Scene& scene);

/// Tables: wiggles (waves, peaks, forces and creepages, by load, scheme, step and distance),
/// dependence (on the step), tractions (of the row at the centre), creepages (under a held force), noise (of these),
/// map (tractions and slip under spin from rest), claims.
std::vector<Table> ellipse_wiggles(const EllipseWigglesParameters& parameters,
                                   const Progress& progress);

}  // namespace microslip::experiments
