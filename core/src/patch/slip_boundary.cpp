// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "component_pairs.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::RowVector2d;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Stiffness against slip along an edge, over that of antiplane shear: 1 - nu across the edge and 1 along
/// it. This is the mean for nu = 0.28; b changes by half of what it differs.
constexpr double stiffness = 0.86;

/// The cell ahead is no part of a zone that sticks if it has more than this part of the slip of the cell
/// behind.
constexpr double least_slip_ahead = 0.1;

/// The slip of a cell counts by its square where it is below this part of the slip of the cell behind.
constexpr double softness = 0.05;

/// The traction of the cell ahead, over its limit, far below which it has no direction: where it passes
/// 0, that jumps.
constexpr double least_traction = 0.03;

/// A value and its derivative.
struct Growing {
  double value, growth;
};

/// z by the slip of the cell over that of the cell behind, as means over a way of 1 cell and more.
Growing place_of(double ratio, double way) {
  constexpr double at_end = 0.514;                   // on a way of one cell
  constexpr double whole = 2 * std::numbers::sqrt2;  // 2^(3/2)
  const double left = std::max(0.0, 2 - way);
  const double scale = at_end * (whole - 1) / (whole - left * std::sqrt(left));
  // Without a kink at 0, where slip that is nearly 0 has any direction.
  const double soft = std::hypot(ratio, softness), smooth = ratio * ratio / soft;
  return {std::min(1.0, smooth / scale), (2 * ratio - smooth * ratio / soft) / soft / scale};
}

/// Slip of the cell behind, over b.
Growing slip_of_behind(double z, double way) {
  const double longer = std::pow(way, -0.8);
  return {longer * (0.69 + (0.9 - 0.31 * z) * z), longer * (0.9 - 0.62 * z)};
}

/// What the cell ahead carries less than its limit, over b.
Growing missing_ahead(double z) { return {1.06 - 0.85 * z, -0.85}; }

/// The part of the kink that is left where the tractions of the cell and of the cell ahead differ in
/// direction, by the cosine of the angle between them: 1 at 0, and 0 from a right angle on.
Growing shared_by(double cosine) {
  return {cosine * cosine * (3 - 2 * cosine), 6 * cosine * (1 - cosine)};
}

/// What the cell carries less, over b.
Growing shortfall_of(double z) {
  const double factor = 0.19 - (0.55 - 0.15 * z) * z;
  return {(1 - z) * factor, -factor - (1 - z) * (0.55 - 0.3 * z)};
}

/// n_x of the normal of the trailing edge at a row.
double normal_along(const JoinedRows& rows, Index k) {
  constexpr double step = 1e-4;
  const Lobe& lobe = rows.shape().lobes()[rows.lobe(k)];
  const double psi = rows.psi(k);
  const auto edge = [&](double at) { return lobe.row(at).middle - lobe.row(at).half_length; };
  const double along = edge(psi + step) - edge(psi - step);
  const double across = lobe.y(psi + step) - lobe.y(psi - step);
  return across / std::hypot(along, across);
}

/// The traction of a cell over its limit.
struct Traction {
  explicit Traction(const Vector2d& q) : size(q.norm()), direction(q.normalized()) {}

  /// The derivative of v.direction by q, which is not 0.
  RowVector2d turning(const Vector2d& v) const {
    return (v - v.dot(direction) * direction).transpose() / size;
  }

  double size;
  Vector2d direction;
};

}  // namespace

SlipBoundary::SlipBoundary(const PatchResponse& response, const VectorXd& limits)
    : response_(&response), limits_(&limits), slips_(VectorXd::Zero(limits.size())) {
  const JoinedRows& rows = response.rows();
  for (Index k = 0; k < rows.rows(); ++k) {
    const double by_traction = 2 * stiffness * normal_along(rows, k);
    for (Index i = 1; i < rows.elements(); ++i) {
      const double side = static_cast<double>(i) * pi / static_cast<double>(rows.elements());
      const Index cell = rows.cell(i, k);
      slips_[cell] = by_traction * std::tan(side / 2) * limits[cell];
    }
  }
}

Shortfall SlipBoundary::shortfall(const PatchState& state, Index cell) const {
  const Index elements = response_->rows().elements(), i = cell % elements;
  if (!response_->rolls() || i == 0 || i == elements - 1) return {};
  const Traction traction(pair_of(state.unknowns, cell) / (*limits_)[cell]);
  const Traction ahead(pair_of(state.unknowns, cell - 1) / (*limits_)[cell - 1]);
  const Vector2d here = pair_of(state.seen_slip, cell), behind = pair_of(state.seen_slip, cell + 1);
  const double slip = std::max(0.0, -here.dot(traction.direction)), slip_behind = behind.norm();
  const double soft = std::hypot(ahead.size, least_traction);
  const Vector2d direction_ahead = ahead.size / soft * ahead.direction;
  const double missing = 1 - ahead.size, cosine = traction.direction.dot(direction_ahead);
  if (slip_behind == 0 || missing <= 0 || cosine <= 0) return {};
  const VectorXd& ways = response_->seen().ways;
  const Growing z = place_of(slip / slip_behind, ways[cell]);
  if (z.value == 1) return {};
  // The part of the zone ahead that sticks.
  const Vector2d seen_ahead = pair_of(state.seen_slip, cell - 1);
  const double slip_ahead = seen_ahead.norm();
  const double sticks = 1 - slip_ahead / (least_slip_ahead * slip_behind);
  if (sticks <= 0) return {};
  // b by both neighbours, and their harmonic mean, which is 0 where one of them has no kink.
  const Growing of_slip = slip_of_behind(z.value, ways[cell + 1]);
  const Growing of_missing = missing_ahead(z.value), part = shortfall_of(z.value);
  const Growing shared = shared_by(cosine);
  const double by_slip = slip_behind / (slips_[cell] * of_slip.value);
  const double by_missing = sticks * shared.value * missing / of_missing.value;
  const double sum = by_slip + by_missing, b = 2 * by_slip * by_missing / sum;
  const double grows_by_slip = 2 * std::pow(by_missing / sum, 2);
  const double grows_by_missing = 2 * std::pow(by_slip / sum, 2);

  Shortfall found;
  found.value = b * part.value;
  const double by_z =
      b * part.growth -
      part.value * (grows_by_slip * by_slip * of_slip.growth / of_slip.value +
                    grows_by_missing * by_missing * of_missing.growth / of_missing.value);
  const double by_kink = part.value * grows_by_missing / of_missing.value;
  const double by_here = by_z * z.growth / slip_behind;
  const double by_sticks = by_kink * shared.value * missing;
  const double by_behind = part.value * grows_by_slip / (slips_[cell] * of_slip.value) +
                           (by_sticks * (1 - sticks) - by_here * slip) / slip_behind;
  found.by_seen_ahead =
      -by_sticks / (least_slip_ahead * slip_behind) * seen_ahead.normalized().transpose();
  const double by_cosine = by_kink * sticks * missing * shared.growth;
  found.by_q_ahead =
      by_cosine / soft * (traction.direction - cosine * direction_ahead).transpose() -
      by_kink * sticks * shared.value * ahead.direction.transpose();
  found.by_q = by_cosine * traction.turning(direction_ahead);
  found.by_seen_behind = by_behind * behind.normalized().transpose();
  if (slip > 0) {
    found.by_q -= by_here * traction.turning(here);
    found.by_seen = -by_here * traction.direction.transpose();
  }
  return found;
}

}  // namespace microslip
