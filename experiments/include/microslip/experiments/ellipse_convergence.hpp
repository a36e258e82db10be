// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// How fast do forces and moment of a contact ellipse converge where a part of it slips? Joined
/// rows beside the standard scheme, and CONTACT's own results by it on a circle; line contacts in
/// the place of ellipses.
struct EllipseConvergenceParameters {
  std::vector<double> aspects{};      ///< a/b
  std::vector<double> lines{};        ///< a/b of ellipses beside line contacts
  double poisson_ratio = 0;           ///< nu of the ellipses
  std::vector<Eigen::Index> sizes{};  ///< square roots of the numbers of cells, rising
  /// The same of the rectangles around an ellipse, by the standard scheme
  std::vector<Eigen::Index> rectangles{};
  Eigen::Index reference = 0;  ///< the same, of the reference
};

/// The keys that `ellipse_convergence --print-keys` lists, each checked against its listed range.
EllipseConvergenceParameters read_ellipse_convergence(Scene& scene);

/// Tables: circle (errors of joined rows, the standard scheme and CONTACT), limits (of the first
/// and the last), ellipses (errors of joined rows and the standard scheme), summary (over all
/// states), lines (line contacts in the place of ellipses), claims.
std::vector<Table> ellipse_convergence(const EllipseConvergenceParameters& parameters,
                                       const Progress& progress);

}  // namespace microslip::experiments
