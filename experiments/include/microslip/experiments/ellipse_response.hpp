// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How do the forces of a contact ellipse follow small creepages and spin that oscillate? Kalker's
/// coefficients as complex functions of the wavelength, by joined rows, beside steps of rolling, the
/// line contact and the limits of long and short waves.
struct EllipseResponseParameters {
  std::vector<double> aspects{};      ///< a/b
  double poisson_ratio = 0;           ///< nu
  std::vector<double> wavelengths{};  ///< L/a, rising
  double shortest = 0, longest = 0;   ///< L/a of curves
  Eigen::Index points = 0;            ///< of curves
  std::vector<Eigen::Index> rows{};   ///< M, rising; N is 5/3 of it
  Eigen::Index reference = 0;         ///< M of the reference
  double resolved = 0;                ///< least L/a of errors and orders
  double period = 0;                  ///< L/a of the longest wave in steps
  std::vector<Eigen::Index> waves{};  ///< numbers of waves in it, rising
  Eigen::Index step_elements = 0;     ///< N in steps, and three fifths as many rows
  std::vector<double> step_ratios{};  ///< c of steps, falling
};

/// The keys that `ellipse_response --print-keys` lists, each checked against its listed range.
EllipseResponseParameters read_ellipse_response(Scene& scene);

/// Tables: coefficients (with errors), curves, errors (against the number of cells), orders,
/// steps (errors of transient schemes), lines (line contacts in the place of ellipses), limits (of
/// long and short waves), claims.
std::vector<Table> ellipse_response(const EllipseResponseParameters& parameters,
                                    const Progress& progress);

}  // namespace microslip::experiments
