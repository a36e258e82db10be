// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_response.hpp"

#include <Eigen/LU>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;
using std::numbers::pi;

namespace {

/// The slip of each cell: the rigid slip halfway, and the difference from the centre of the cell to
/// the point ahead.
SlipMap slip_map(const JoinedRows& rows, double nu) {
  const JoinedRows::Kernels kernels = rows.kernels();
  const Index n = rows.cells();
  SlipMap map{MatrixXd(2 * n, 2 * n), MatrixX3d(2 * n, 3)};
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Index here = 2 * i + 1, ahead = i == 0 ? 0 : here - 2;
      const double from = rows.x(ahead, k), to = rows.x(here, k);
      const auto slip_by = [&](const MatrixXd& kernel) -> Eigen::RowVectorXd {
        return (kernel.row(rows.point(here, k)) - kernel.row(rows.point(ahead, k))) /
               (pi * (from - to));
      };
      const Eigen::RowVectorXd near = slip_by(kernels.near), across = slip_by(kernels.across);
      const Eigen::RowVectorXd mixed = nu * slip_by(kernels.mixed);
      const Index cell = rows.cell(i, k);
      map.by_traction.row(cell) << near - nu * across, mixed;
      map.by_traction.row(n + cell) << mixed, (1 - nu) * near + nu * across;
      map.by_motion.row(cell) << 1, 0, -rows.y(k);
      map.by_motion.row(n + cell) << 0, 1, (from + to) / 2;
    }
  }
  return map;
}

}  // namespace

PatchResponse::PatchResponse(const JoinedRows& rows, double poisson_ratio) : rows_(rows) {
  require(poisson_ratio >= 0 && poisson_ratio <= 0.5, "poisson_ratio", poisson_ratio,
          "a number from 0 to 0.5");
  own_ = slip_map(rows, poisson_ratio);
  adhering_ = -own_.by_traction.partialPivLu().solve(own_.by_motion);
  const Index n = rows.cells();
  const Eigen::Matrix3Xd moments = rows.moments();
  resultants_.setZero(3, 2 * n);
  resultants_.row(0).head(n) = moments.row(0);
  resultants_.row(1).tail(n) = moments.row(0);
  resultants_.row(2) << -moments.row(2), moments.row(1);
}

}  // namespace microslip
