// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_scale.hpp"

#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd limits_of(const JoinedRows& rows, const PatchBound& bound) {
  VectorXd limits(rows.cells());
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const double theta = rows.theta(i);
      const double limit = bound(rows.lobe(k), rows.psi(k), theta) / bound.peak();
      require(limit > 0, "bound", limit * bound.peak(), "a number > 0 at the centres of all cells");
      limits[rows.cell(i, k)] = limit / std::tan(theta / 2);
    }
  }
  return limits;
}

}  // namespace microslip
