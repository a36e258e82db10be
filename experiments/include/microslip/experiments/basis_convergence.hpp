// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/reference/carter.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Do higher-order basis functions converge faster? Thesis Fig. 6.9, appendix B: the Carter-Fromm
/// problem with constant, linear and quadratic functions; the quadratic ones also with the
/// integration limits as printed in (B.30).
struct BasisConvergenceParameters {
  Material material;
  double length = 0;  ///< L0 of the plane kernel  [mm]
  HertzBound bound;
  std::vector<Eigen::Index> sizes{};  ///< N, odd, ascending, at least two
  double leading_offset = 0;          ///< last node to leading edge, in (0, 1]  [dx]
  double trailing_offset = 0;         ///< trailing edge to first node, in [0, 1]  [dx]
  double step_ratio = 0;              ///< c  [1]
  double stick_ratio = 0;             ///< a', in (0, 1)
};

/// The keys that `basis_convergence --print-keys` lists, each checked against its listed range.
BasisConvergenceParameters read_basis_convergence(Scene& scene);

/// Tables: errors (one row per basis and N), orders (one row per basis and quantity), claims.
std::vector<Table> basis_convergence(const BasisConvergenceParameters& parameters,
                                     const Progress& progress);

}  // namespace microslip::experiments
