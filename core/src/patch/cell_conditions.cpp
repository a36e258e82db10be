// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_conditions.hpp"

#include <algorithm>

#include "component_pairs.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

/// A cell that slips counts as within the disc if |z| is less than 1 by so much. At the start of an
/// attempt z is on the disc.
constexpr double within_disc = 1e-6;

/// r0 of each cell: the reciprocal of the largest own slip in its row by a unit of q in one cell.
VectorXd lengths_of(const PatchResponse& response, const VectorXd& limits) {
  const JoinedRows& rows = response.rows();
  const Index n = rows.cells();
  VectorXd lengths(n);
  for (Index k = 0; k < rows.rows(); ++k) {
    const auto of_row = Eigen::seqN(rows.cell(0, k), rows.elements());
    const auto slip = response.stiffness().head(n).cwiseMax(response.stiffness().tail(n));
    lengths(of_row).setConstant(1 / slip.cwiseProduct(limits)(of_row).maxCoeff());
  }
  return lengths;
}

/// The slip in the condition of a cell: t + part (c - t), and how the part grows.
struct MixedSlip {
  Vector2d value;
  double part, growth;  ///< growth by |q - r0 t|

  MixedSlip(const Vector2d& own, const Vector2d& centre, double beyond, double width) {
    part = std::clamp(beyond / width, 0.0, 1.0);
    growth = part > 0 && part < 1 ? 1 / width : 0;
    value = own + part * (centre - own);
  }
};

}  // namespace

CellConditions::CellConditions(const PatchResponse& response, const VectorXd& limits)
    : limits_(&limits), lengths_(lengths_of(response, limits)) {}

void CellConditions::set(double length_ratio, double width) {
  length_ratio_ = length_ratio;
  width_ = width;
}

Vector2d CellConditions::quotient(const PatchState& state, Index i) const {
  return pair_of(state.unknowns, i) / (*limits_)[i];
}

VectorXd CellConditions::quotients(const PatchState& state) const {
  VectorXd q(2 * limits_->size());
  for (Index i = 0; i < limits_->size(); ++i) set_pair(q, i, onto_disc(quotient(state, i)));
  return q;
}

bool CellConditions::slips_next(const PatchState& state, Index i) const {
  const double length = lengths_[i] * length_ratio_;
  return (quotient(state, i) - length * pair_of(state.own_slip, i)).norm() > 1;
}

Vector2d CellConditions::slip(const PatchState& state, Index i) const {
  const Vector2d q = quotient(state, i), own = pair_of(state.own_slip, i);
  const double beyond = (q - lengths_[i] * own).norm() - 1;
  return MixedSlip(own, pair_of(state.centre_slip, i), beyond, width_).value;
}

double CellConditions::error(const PatchState& state, Index i) const {
  const Vector2d q = quotient(state, i);
  return (q - onto_disc(q - lengths_[i] * slip(state, i))).norm();
}

double CellConditions::residual(const PatchState& state) const {
  double largest = 0;
  for (Index i = 0; i < limits_->size(); ++i) {
    const double found = error(state, i);
    if (!(found <= largest)) largest = found;
  }
  return largest;
}

CellCondition CellConditions::about(const PatchState& state, Index i, const Vector2d& q) const {
  const Vector2d own = pair_of(state.own_slip, i), centre = pair_of(state.centre_slip, i);
  const double own_length = lengths_[i], length = length_ratio_ * own_length;
  const MixedSlip slip(own, centre, (q - own_length * own).norm() - 1, width_);
  const Vector2d z = q - length * slip.value;
  Vector2d e = Vector2d::Zero();
  Matrix2d D = Matrix2d::Identity();
  if (z.norm() > 1 - within_disc) {
    e = z.normalized();
    D = (D - e * e.transpose()) / z.norm();
  }
  CellCondition found{.by_q = Matrix2d::Identity() - D,
                      .by_own = length * (1 - slip.part) * D,
                      .by_centre = length * slip.part * D,
                      .right = e};
  if (slip.growth > 0) {
    const Vector2d beyond = q - own_length * own;
    const Matrix2d turned =
        length * slip.growth * D * (centre - own) * beyond.normalized().transpose();
    found.by_q += turned;
    found.by_own -= own_length * turned;
    found.right += turned * beyond;
  }
  return found;
}

}  // namespace microslip
