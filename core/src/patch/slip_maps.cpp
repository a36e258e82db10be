// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_maps.hpp"

#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using std::numbers::pi;

PatchResponse::Matrix displacement_by_traction(const JoinedRows& rows, double poisson_ratio) {
  require(poisson_ratio >= 0 && poisson_ratio <= 0.5, "poisson_ratio", poisson_ratio,
          "a number from 0 to 0.5");
  const JoinedRows::Kernels kernels = rows.kernels();
  const double nu = poisson_ratio;
  PatchResponse::Matrix displacement(2 * rows.points(), 2 * rows.cells());
  displacement << kernels.near - nu * kernels.across, nu * kernels.mixed, nu * kernels.mixed,
      (1 - nu) * kernels.near + nu * kernels.across;
  displacement /= pi;
  return displacement;
}

PatchSlipMap map_for(const JoinedRows& rows) {
  const Index n = rows.cells();
  return {MatrixXd::Zero(2 * n, 2 * n), Eigen::MatrixX3d::Zero(2 * n, 3)};
}

void set_slip(PatchSlipMap& map, const JoinedRows& rows, const PatchResponse::Matrix& displacement,
              Index i, Index k, const PointSlip& slip, double y) {
  const Index n = rows.cells(), cell = rows.cell(i, k);
  map.by_traction.row(cell).setZero();
  map.by_traction.row(n + cell).setZero();
  for (std::size_t l = 0; l < slip.points.size(); ++l) {
    if (slip.weights[l] == 0) continue;
    const Index point = rows.point(slip.points[l], k);
    map.by_traction.row(cell) += slip.weights[l] * displacement.row(point);
    map.by_traction.row(n + cell) += slip.weights[l] * displacement.row(rows.points() + point);
  }
  map.by_motion.row(cell) << 1, 0, -y;
  map.by_motion.row(n + cell) << 0, 1, slip.x;
}

Index mirrored(const JoinedRows& rows, Index j) {
  const Index last = 2 * rows.elements();
  return j < 0 ? -j : j > last ? 2 * last - j : j;
}

std::array<double, 4> cubic_weights(double at, Index first) {
  std::array<double, 4> weights{1, 1, 1, 1};
  for (Index j = 0; j < 4; ++j) {
    for (Index l = 0; l < 4; ++l) {
      if (l == j) continue;
      weights[static_cast<std::size_t>(j)] *=
          (at - static_cast<double>(first + l)) / static_cast<double>(j - l);
    }
  }
  return weights;
}

PointSlip between(const JoinedRows& rows, double theta) {
  const double at = theta / pi * static_cast<double>(2 * rows.elements());
  const auto first = static_cast<Index>(std::floor(at)) - 1;
  const std::array<double, 4> weights = cubic_weights(at, first);
  PointSlip found{};
  for (std::size_t j = 0; j < weights.size(); ++j) {
    found.points[j] = mirrored(rows, first + static_cast<Index>(j));
    found.weights[j] = weights[j];
  }
  return found;
}

Eigen::Matrix3Xd resultants_by_traction(const JoinedRows& rows) {
  const Index n = rows.cells();
  const Eigen::Matrix3Xd moments = rows.moments();
  Eigen::Matrix3Xd resultants = Eigen::Matrix3Xd::Zero(3, 2 * n);
  resultants.row(0).head(n) = moments.row(0);
  resultants.row(1).tail(n) = moments.row(0);
  resultants.row(2) << -moments.row(2), moments.row(1);
  return resultants;
}

PointSlip centre_slip(const JoinedRows& rows, Index i, Index k) {
  const Index here = 2 * i + 1;
  const double step = pi / static_cast<double>(rows.elements());
  const double scale = rows.half_length(k) * std::sin(rows.theta(i)) * step;
  const double near = 4.0 / 3 / scale, far = -1.0 / 6 / scale;
  return {{here + 1, here - 1, mirrored(rows, here + 2), mirrored(rows, here - 2), here},
          {near, -near, far, -far, 0},
          rows.x(here, k)};
}

}  // namespace microslip
