// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_response.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;
using std::numbers::pi;

namespace {

/// Slip as a linear function of the unknowns and of the motion.
struct SlipMap {
  MatrixXd by_traction;  ///< 2n x 2n
  MatrixX3d by_motion;   ///< 2n x 3
};

/// A difference of values at points of a row, which approximates -d/dx, and the place of it.
struct Difference {
  std::array<Index, 4> points;
  std::array<double, 4> weights;
  double x;
};

/// Makes the slip of all cells from a difference for each.
template <class DifferenceOf>
SlipMap slip_map(const JoinedRows& rows, const JoinedRows::Kernels& kernels, double nu,
                 const DifferenceOf& difference_of) {
  const Index n = rows.cells();
  SlipMap map{MatrixXd(2 * n, 2 * n), MatrixX3d(2 * n, 3)};
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Difference difference = difference_of(i, k);
      const auto slip_by = [&](const MatrixXd& kernel) {
        Eigen::RowVectorXd slip = Eigen::RowVectorXd::Zero(n);
        for (std::size_t l = 0; l < difference.points.size(); ++l) {
          slip += difference.weights[l] / pi * kernel.row(rows.point(difference.points[l], k));
        }
        return slip;
      };
      const Eigen::RowVectorXd near = slip_by(kernels.near), across = slip_by(kernels.across);
      const Eigen::RowVectorXd mixed = nu * slip_by(kernels.mixed);
      const Index cell = rows.cell(i, k);
      map.by_traction.row(cell) << near - nu * across, mixed;
      map.by_traction.row(n + cell) << mixed, (1 - nu) * near + nu * across;
      map.by_motion.row(cell) << 1, 0, -rows.y(k);
      map.by_motion.row(n + cell) << 0, 1, difference.x;
    }
  }
  return map;
}

/// Makes the own slip, from the centre of a cell to the point ahead: the centre ahead, or the
/// leading edge. It is the slip halfway.
SlipMap map_own_slip(const JoinedRows& rows, const JoinedRows::Kernels& kernels, double nu) {
  return slip_map(rows, kernels, nu, [&](Index i, Index k) {
    const Index here = 2 * i + 1, ahead = i == 0 ? 0 : here - 2;
    const double from = rows.x(ahead, k), to = rows.x(here, k);
    const double weight = 1 / (from - to);
    return Difference{{here, ahead, 0, 0}, {weight, -weight, 0, 0}, (from + to) / 2};
  });
}

/// Makes the slip at centres by differences of fourth order in theta. Displacements are even in
/// theta at both edges, as they are smooth in x.
SlipMap map_centre_slip(const JoinedRows& rows, const JoinedRows::Kernels& kernels, double nu) {
  const Index last = 2 * rows.elements();
  const auto mirrored = [&](Index j) { return j < 0 ? -j : j > last ? 2 * last - j : j; };
  return slip_map(rows, kernels, nu, [&](Index i, Index k) {
    const Index here = 2 * i + 1;
    const double step = pi / static_cast<double>(rows.elements());
    const double scale = rows.half_length(k) * std::sin(rows.theta(i)) * step;
    const double near = 4.0 / 3 / scale, far = -1.0 / 6 / scale;
    return Difference{{here + 1, here - 1, mirrored(here + 2), mirrored(here - 2)},
                      {near, -near, far, -far},
                      rows.x(here, k)};
  });
}

}  // namespace

PatchResponse::PatchResponse(const JoinedRows& rows, double poisson_ratio) : rows_(rows) {
  require(poisson_ratio >= 0 && poisson_ratio <= 0.5, "poisson_ratio", poisson_ratio,
          "a number from 0 to 0.5");
  const JoinedRows::Kernels kernels = rows.kernels();
  const SlipMap own = map_own_slip(rows, kernels, poisson_ratio);
  const SlipMap centre = map_centre_slip(rows, kernels, poisson_ratio);
  unknowns_ = own.by_traction.inverse();
  const auto norm = [](const auto& map) { return map.cwiseAbs().colwise().sum().maxCoeff(); };
  condition_ = norm(own.by_traction) * norm(unknowns_);
  centre_slip_ = centre.by_traction * unknowns_;
  rigid_own_slip_ = own.by_motion;
  rigid_centre_slip_ = centre.by_motion;
  stiffness_ = own.by_traction.diagonal();
  const Index n = rows.cells();
  const Eigen::Matrix3Xd moments = rows.moments();
  resultants_.setZero(3, 2 * n);
  resultants_.row(0).head(n) = moments.row(0);
  resultants_.row(1).tail(n) = moments.row(0);
  resultants_.row(2) << -moments.row(2), moments.row(1);
  relief_ = resultants_ * unknowns_;
  linear_ = -relief_ * rigid_own_slip_;
}

}  // namespace microslip
