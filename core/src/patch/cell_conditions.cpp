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

/// |q - r0 t| - 1 from which the slip is that at the centre, in steady rolling.
constexpr double transition = 0.3;

/// The same of each cell. The shorter a step, the shorter r0, and so the transition: it ends at the
/// same slip in steps of all lengths.
VectorXd transitions_of(const PatchResponse& response, Index cells) {
  if (!response.rolls()) return VectorXd::Constant(cells, transition);
  return transition * (response.seen().by_own + response.seen().by_ahead);
}

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

CellCondition::BySlip& CellCondition::term_of(Index cell) {
  for (std::size_t j = 0; j < count; ++j) {
    if (terms[j].cell == cell) return terms[j];
  }
  terms[count] = {.cell = cell};
  return terms[count++];
}

CellConditions::CellConditions(const PatchResponse& response, const VectorXd& limits)
    : response_(&response),
      limits_(&limits),
      lengths_(lengths_of(response, limits)),
      turning_(response, limits),
      boundary_(response, limits),
      shortfalls_(static_cast<std::size_t>(limits.size())),
      discs_(shortfalls_.size()),
      transitions_(transitions_of(response, limits.size())) {}

void CellConditions::look_at(const PatchState& state) {
  state_ = &state;
  if (keeps_discs_) return;
  turning_.look_at(state);
  for (Index i = 0; i < limits_->size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    shortfalls_[at] = boundary_.shortfall(state, i);
    discs_[at] = turning_.disc(i);
    discs_[at].centre *= carried(i);
    discs_[at].radius *= carried(i);
  }
}

Vector2d CellConditions::quotient(Index i) const {
  return pair_of(state_->unknowns, i) / (*limits_)[i];
}

Vector2d CellConditions::on_disc(Index i, const Vector2d& q) const {
  return disc(i).centre + onto_disc(q - disc(i).centre, disc(i).radius);
}

Vector2d CellConditions::on_circle(Index i) const {
  return disc(i).centre + disc(i).radius * (quotient(i) - disc(i).centre).normalized();
}

VectorXd CellConditions::quotients() const {
  VectorXd q(2 * limits_->size());
  for (Index i = 0; i < limits_->size(); ++i) set_pair(q, i, on_disc(i, quotient(i)));
  return q;
}

void CellConditions::find_carried(VectorXd& parts) const {
  parts.resize(limits_->size());
  for (Index i = 0; i < parts.size(); ++i) parts[i] = carried(i);
}

bool CellConditions::slips_next(Index i, const Vector2d& q) const {
  const FrictionDisc& of = disc(i);
  if (of.radius == 0) return true;
  const double length = lengths_[i] * length_ratio_;
  return (q - of.centre - length * pair_of(state_->own_slip, i)).norm() > of.radius;
}

Vector2d CellConditions::slip(Index i) const {
  const FrictionDisc& of = disc(i);
  const Vector2d y = quotient(i) - of.centre, own = pair_of(state_->own_slip, i);
  const double beyond = (y - lengths_[i] * own).norm() - of.radius;
  return MixedSlip(own, pair_of(state_->centre_slip, i), beyond, transitions_[i]).value;
}

Vector2d CellConditions::error(Index i) const {
  const FrictionDisc& of = disc(i);
  const Vector2d y = quotient(i) - of.centre;
  return y - onto_disc(y - lengths_[i] * slip(i), of.radius);
}

double CellConditions::residual() const {
  double largest = 0;
  for (Index i = 0; i < limits_->size(); ++i) {
    const double found = error(i).norm();
    if (!(found <= largest)) largest = found;
  }
  return largest;
}

bool CellConditions::has_centre_slip(Index i, const std::vector<bool>& slips) const {
  return slips[static_cast<std::size_t>(i)] || turning_.is_enclosed(i, slips);
}

/// Adds what a condition depends on by the own slip of a cell.
void CellConditions::add_own(Index cell, const Matrix2d& by_own, CellCondition& found) const {
  if (!state_->slips[static_cast<std::size_t>(cell)]) return;
  found.term_of(cell).by_own += by_own;
  found.right += by_own * pair_of(state_->own_slip, cell);
}

/// Adds what a condition depends on by the slip that is seen in a cell.
void CellConditions::add_seen(Index cell, const Matrix2d& by_seen, CellCondition& found) const {
  const SeenSlip& seen = response_->seen();
  add_own(cell, seen.by_own[cell] * by_seen, found);
  if (seen.by_ahead[cell] != 0) add_own(cell - 1, seen.by_ahead[cell] * by_seen, found);
}

/// Adds what a disc depends on by the shortfall.
/// \param by_value  derivative of the condition's left side by the shortfall
void CellConditions::add_shortfall(Index i, const Vector2d& by_value, CellCondition& found) const {
  const Shortfall& less = shortfalls_[static_cast<std::size_t>(i)];
  if (less.value == 0) return;
  add_seen(i - 1, by_value * less.by_seen_ahead, found);
  add_seen(i, by_value * less.by_seen, found);
  add_seen(i + 1, by_value * less.by_seen_behind, found);
  const Matrix2d by_q = by_value * less.by_q_ahead, by_own_q = by_value * less.by_q;
  found.term_of(i - 1).by_q += by_q;
  found.by_q += by_own_q;
  found.right += by_q * quotient(i - 1) + by_own_q * quotient(i);
}

CellCondition CellConditions::about(Index i, const Vector2d& q) const {
  const bool is_enclosed = keeps_discs_ || turning_.is_enclosed(i, state_->slips);
  const FrictionDisc disc = is_enclosed ? this->disc(i) : FrictionDisc{.radius = carried(i)};
  const Vector2d own = pair_of(state_->own_slip, i), centre = pair_of(state_->centre_slip, i);
  const double own_length = lengths_[i], length = length_ratio_ * own_length;
  const Vector2d y = q - disc.centre, beyond = y - own_length * own;
  const MixedSlip slip(own, centre, beyond.norm() - disc.radius, transitions_[i]);
  const Vector2d z = y - length * slip.value;
  Vector2d e = Vector2d::Zero();
  Matrix2d D = Matrix2d::Identity();
  if (disc.radius == 0) {
    D.setZero();
  } else if (z.norm() > disc.radius * (1 - within_disc)) {
    e = z.normalized();
    D = disc.radius * (D - e * e.transpose()) / z.norm();
  }
  CellCondition found;
  found.slides = !e.isZero();
  found.by_q = Matrix2d::Identity() - D;
  found.terms[0] = {
      .cell = i, .by_own = length * (1 - slip.part) * D, .by_centre = length * slip.part * D};
  Vector2d by_radius = -e;
  found.right = disc.radius * e;
  if (slip.growth > 0) {
    const Vector2d grown = length * slip.growth * D * (centre - own);
    const Matrix2d turned = grown * beyond.normalized().transpose();
    found.by_q += turned;
    found.terms[0].by_own -= own_length * turned;
    found.right += turned * beyond;
    by_radius -= grown;
  }
  found.right += found.by_q * disc.centre;
  if (keeps_discs_) return found;
  if (!is_enclosed || turning_.disc(i).radius == 1) {
    add_shortfall(i, -by_radius, found);
    return found;
  }
  const Vector2d by_shortfall =
      found.by_q * turning_.disc(i).centre - turning_.disc(i).radius * by_radius;
  const Matrix2d by_centre = carried(i) * found.by_q;
  const DiscGrowth by = turning_.growth(i);
  const std::array<Index, 9> cells = turning_.around(i);
  for (std::size_t j = 0; j < cells.size(); ++j) {
    const Index cell = cells[j];
    const Matrix2d by_slip =
        carried(i) * by_radius * by.radius_by_slip[j] - by_centre * by.centre_by_slip[j];
    const Vector2d by_pole = -by_centre * by.centre_by_pole[j];
    add_seen(cell, carried(i) * by_radius * by.radius_by_seen[j] - by_centre * by.centre_by_seen[j],
             found);
    CellCondition::BySlip& term = found.term_of(cell);
    term.by_centre += by_slip;
    term.by_pole += by_pole;
    found.right +=
        by_slip * pair_of(state_->centre_slip, cell) + by_pole * turning_.pole_slip(cell);
  }
  add_shortfall(i, by_shortfall, found);
  return found;
}

}  // namespace microslip
