// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using std::numbers::pi;

namespace {

/// The slip at a pole that cells lack, over g/G: one number for all grids and ratios, by which forces
/// of ellipses that slide with a strong spin have their limits under refinement.
constexpr double slip_at_pole = 0.45;

/// The cells on a square around a cell, one or two cells from it.
class Ring {
 public:
  Ring(const JoinedRows& rows, Index i, Index k, Index distance) {
    for (Index a = -distance; a <= distance; ++a) {
      for (Index b = -distance; b <= distance; ++b) {
        if (std::max(std::abs(a), std::abs(b)) != distance) continue;
        const double x = rows.x(2 * (i + b) + 1, k + a) - rows.x(2 * i + 1, k);
        const double y = rows.y(k + a) - rows.y(k);
        places_[count_++] = {.cell = rows.cell(i + b, k + a),
                             .factor = std::tan(rows.theta(i + b) / 2),
                             .x = x,
                             .y = y};
        radius_ += std::hypot(x, y);
      }
    }
    radius_ /= static_cast<double>(count_);
  }

  /// The mean distance from the middle.
  double radius() const { return radius_; }

  /// Adds the mean of the tractions across the radius, times a factor, to a row of a map.
  void add_turn(std::vector<Eigen::Triplet<double>>& map, Index row, Index n, double factor) const {
    for (std::size_t j = 0; j < count_; ++j) {
      const auto& [cell, by_unknown, x, y] = places_[j];
      const double weight = factor * by_unknown / static_cast<double>(count_) / std::hypot(x, y);
      map.emplace_back(row, cell, -weight * y);
      map.emplace_back(row, n + cell, weight * x);
    }
  }

 private:
  struct Place {
    Index cell;
    double factor;  ///< p/v
    double x, y;    ///< from the middle
  };

  std::array<Place, 16> places_;
  std::size_t count_ = 0;
  double radius_ = 0;
};

}  // namespace

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

PatchResponse::Stencils map_pole(const JoinedRows& rows,
                                 const std::function<double(Index, Index)>& part) {
  std::vector<Eigen::Triplet<double>> entries;
  const Index n = rows.cells();
  for (Index k = 2; k + 2 < rows.rows(); ++k) {
    if (rows.lobe(k - 2) != rows.lobe(k + 2)) continue;
    for (Index i = 2; i + 2 < rows.elements(); ++i) {
      const Ring near(rows, i, k, 1), far(rows, i, k, 2);
      const double scale = part(i, k) * slip_at_pole / (far.radius() - near.radius());
      near.add_turn(entries, rows.cell(i, k), n, -scale * far.radius());
      far.add_turn(entries, rows.cell(i, k), n, scale * near.radius());
    }
  }
  PatchResponse::Stencils map(n, 2 * n);
  map.setFromTriplets(entries.begin(), entries.end());
  return map;
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
