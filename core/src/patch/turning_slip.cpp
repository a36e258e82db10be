// SPDX-License-Identifier: GPL-3.0-or-later
#include "turning_slip.hpp"

#include <algorithm>
#include <cmath>

#include "component_pairs.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::RowVector2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr std::size_t middle = 4;

/// Slip that is seen of a cell around, over the largest bound in its row, from which it slips in full.
constexpr double full_slip = 0.7;

/// 1 - |mean direction| of the cells around, from which the slip turns, and from which in full.
constexpr double least_turn = 0.08, full_turn = 0.25;

/// Slip over the same bound, far below which it has no direction: rounding has any.
constexpr double least_slip = 1e-4;

/// The slip of nine cells, along and across.
using NineSlips = Eigen::Matrix<double, 9, 2>;

/// A ramp from 0 to 1 without kinks.
struct Ramp {
  double value, growth;

  explicit Ramp(double x) {
    const double part = std::clamp(x, 0.0, 1.0);
    value = part * part * (3 - 2 * part);
    growth = 6 * part * (1 - part);
  }
};

/// How much the slip turns, by the mean direction of the cells around.
Ramp turn_of(const Vector2d& mean) {
  return Ramp((1 - mean.norm() - least_turn) / (full_turn - least_turn));
}

/// Weights of the nine slips at points in the cell and in half of the way beyond, and of the points.
class Points {
 public:
  static constexpr int fine = 6, coarse = 2, count = fine * fine + 4 * coarse * coarse;

  Points() {
    constexpr double of_neighbour = 1.0 / 24;
    add_cell(0, 0, fine, 1 + 4 * of_neighbour);
    for (const int to : {-1, 1}) {
      add_cell(to, 0, coarse, -of_neighbour);
      add_cell(0, to, coarse, -of_neighbour);
    }
  }

  Eigen::Matrix<double, count, 9> slips;
  Eigen::Array<double, count, 1> weights;

 private:
  void add_cell(int row, int element, int sides, double weight) {
    for (int j = 0; j < sides; ++j) {
      for (int l = 0; l < sides; ++l) {
        const Eigen::Vector3d along_rows = parabola(row + (j + 0.5) / sides - 0.5);
        const Eigen::Vector3d along_elements = parabola(element + (l + 0.5) / sides - 0.5);
        for (Index a = 0; a < 3; ++a) {
          slips.row(added_).segment<3>(3 * a) = along_rows[a] * along_elements.transpose();
        }
        weights[added_++] = weight / (sides * sides);
      }
    }
  }

  /// Weights of values at -1, 0 and 1.
  static Eigen::Vector3d parabola(double at) {
    return {at * (at - 1) / 2, 1 - at * at, at * (at + 1) / 2};
  }

  Index added_ = 0;
};

const Points& points() {
  static const Points made;
  return made;
}

/// The mean direction of friction in the cell amid nine, and its derivatives by their slip.
///
/// Directions s/|s| are s/sqrt(|s|^2 + e^2), with e of half the distance between points times the
/// gradient of the slip, so that the mean is smooth where the pole passes a point.
class MeanDirection {
 public:
  explicit MeanDirection(const NineSlips& slips) {
    difference_ = slips.rowwise() - slips.colwise().mean();
    at_points_ = points().slips * slips;
    reciprocal_ =
        (at_points_.rowwise().squaredNorm().array() + softness * difference_.squaredNorm()).rsqrt();
    mean_ = -at_points_.transpose() * (points().weights * reciprocal_).matrix();
    length_ = mean_.norm();
  }

  Vector2d value() const { return onto_disc(mean_); }

  /// By the slip of each of the nine cells.
  std::array<Matrix2d, 9> growth() const {
    const auto x = at_points_.col(0).array(), y = at_points_.col(1).array();
    const OfPoints singles = points().weights * reciprocal_;
    const OfPoints cubes = singles * reciprocal_.square();
    Eigen::Matrix<double, Points::count, 3> by_slip;  // xx, xy, yy
    by_slip << cubes * x * x - singles, cubes * x * y, cubes * y * y - singles;
    const Eigen::Matrix<double, 9, 3> sums = points().slips.transpose() * by_slip;
    const Vector2d by_square = at_points_.transpose() * cubes.matrix();
    Matrix2d within = Matrix2d::Identity();
    if (length_ > 1) {
      const Vector2d e = mean_ / length_;
      within = (within - e * e.transpose()) / length_;
    }
    std::array<Matrix2d, 9> found;
    for (Index j = 0; j < 9; ++j) {
      const Matrix2d by_one{{sums(j, 0), sums(j, 1)}, {sums(j, 1), sums(j, 2)}};
      found[static_cast<std::size_t>(j)] =
          within * (by_one + softness * by_square * difference_.row(j));
    }
    return found;
  }

 private:
  /// e^2 over the sum of the squares of the differences from the mean slip.
  static constexpr double softness = 0.006 / 9;

  using OfPoints = Eigen::Array<double, Points::count, 1>;

  NineSlips difference_;
  Eigen::Matrix<double, Points::count, 2> at_points_;
  OfPoints reciprocal_;
  Vector2d mean_;
  double length_;
};

}  // namespace

TurningSlip::TurningSlip(const PatchResponse& response, const VectorXd& limits)
    : response_(&response),
      bounds_(limits.size()),
      elements_(response.rows().elements()),
      is_inner_(static_cast<std::size_t>(limits.size()), false),
      discs_(is_inner_.size()),
      directions_(2, limits.size()),
      sizes_(limits.size()),
      parts_(limits.size()),
      pole_slip_(limits.size()) {
  const JoinedRows& rows = response.rows();
  for (Index k = 0; k < rows.rows(); ++k) {
    double largest = 0;
    for (Index i = 0; i < elements_; ++i) {
      largest = std::max(largest, limits[rows.cell(i, k)] * std::tan(rows.theta(i) / 2));
    }
    bounds_.segment(rows.cell(0, k), elements_).setConstant(largest);
  }
  if (!response.rolls()) return;
  for (Index k = 1; k + 1 < rows.rows(); ++k) {
    if (rows.lobe(k - 1) != rows.lobe(k + 1)) continue;
    for (Index i = 1; i + 1 < elements_; ++i) {
      is_inner_[static_cast<std::size_t>(rows.cell(i, k))] = true;
    }
  }
}

std::array<Index, 9> TurningSlip::around(Index cell) const {
  std::array<Index, 9> cells;
  for (Index a = 0; a < 3; ++a) {
    for (Index b = 0; b < 3; ++b) {
      cells[static_cast<std::size_t>(3 * a + b)] = cell + (a - 1) * elements_ + b - 1;
    }
  }
  return cells;
}

bool TurningSlip::is_enclosed(Index cell, const std::vector<bool>& slips) const {
  return is_inner_[static_cast<std::size_t>(cell)] &&
         std::ranges::all_of(around(cell), [&](Index i) {
           return i == cell || slips[static_cast<std::size_t>(i)];
         });
}

TurningSlip::Ring TurningSlip::ring_of(Index cell) const {
  Ring ring{1, Vector2d::Zero()};
  const std::array<Index, 9> cells = around(cell);
  for (std::size_t j = 0; j < cells.size(); ++j) {
    if (j == middle) continue;
    ring.slip *= parts_[cells[j]];
    ring.mean += directions_.col(cells[j]) / 8;
  }
  return ring;
}

NineSlips TurningSlip::slips_about(Index cell) const {
  NineSlips slips;
  const std::array<Index, 9> cells = around(cell);
  for (Index j = 0; j < 9; ++j) {
    const Index i = cells[static_cast<std::size_t>(j)];
    slips.row(j) = pair_of(state_->centre_slip, i);
    slips(j, 1) += pole_slip_[i];
  }
  return slips;
}

void TurningSlip::look_at(const PatchState& state) {
  state_ = &state;
  for (Index i = 0; i < bounds_.size(); ++i) {
    const Vector2d slip = pair_of(state.centre_slip, i);
    sizes_[i] = std::hypot(slip.norm(), least_slip * bounds_[i]);
    directions_.col(i) = slip / sizes_[i];
    const bool slips = state.slips[static_cast<std::size_t>(i)];
    parts_[i] =
        slips ? Ramp(pair_of(state.seen_slip, i).norm() / (full_slip * bounds_[i])).value : 0;
  }
  bool has_pole_slip = false;
  for (Index i = 0; i < bounds_.size(); ++i) {
    FrictionDisc& disc = discs_[static_cast<std::size_t>(i)];
    disc = {};
    if (!is_inner_[static_cast<std::size_t>(i)]) continue;
    const Ring ring = ring_of(i);
    const double weight = ring.slip * turn_of(ring.mean).value;
    if (weight == 0) continue;
    if (!has_pole_slip) pole_slip_.noalias() = response_->pole() * state.unknowns;
    has_pole_slip = true;
    disc = {.centre = weight * MeanDirection(slips_about(i)).value(), .radius = 1 - weight};
  }
}

DiscGrowth TurningSlip::growth(Index cell) const {
  const std::array<Index, 9> cells = around(cell);
  const Ring ring = ring_of(cell);
  const Ramp turn = turn_of(ring.mean);
  const double weight = ring.slip * turn.value;
  const MeanDirection mean(slips_about(cell));
  const std::array<Matrix2d, 9> by_slip = mean.growth();
  DiscGrowth growth;
  for (std::size_t j = 0; j < cells.size(); ++j) {
    RowVector2d weight_by_seen = RowVector2d::Zero(), weight_by_slip = RowVector2d::Zero();
    if (j != middle) {
      const Vector2d seen = pair_of(state_->seen_slip, cells[j]);
      const Vector2d e = directions_.col(cells[j]);
      const double full = full_slip * bounds_[cells[j]];
      const Ramp part(seen.norm() / full);
      weight_by_seen = weight * part.growth / part.value / full * seen.normalized().transpose();
      weight_by_slip = -ring.slip * turn.growth / (full_turn - least_turn) / 8 *
                       ring.mean.normalized().transpose() *
                       (Matrix2d::Identity() - e * e.transpose()) / sizes_[cells[j]];
    }
    growth.centre_by_seen[j] = mean.value() * weight_by_seen;
    growth.centre_by_pole[j] = weight * by_slip[j].col(1);
    growth.centre_by_slip[j] = weight * by_slip[j] + mean.value() * weight_by_slip;
    growth.radius_by_seen[j] = -weight_by_seen;
    growth.radius_by_slip[j] = -weight_by_slip;
  }
  return growth;
}

}  // namespace microslip
