// SPDX-License-Identifier: GPL-3.0-or-later
#include "adhesion_system.hpp"

#include <algorithm>
#include <utility>

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Factors and border conditioned worse than this together would lose digits that new factors keep:
/// one refinement recovers what is lost above it.
constexpr double least_rcond = 1e-10;

std::size_t to_size(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

AdhesionSystem::AdhesionSystem(const MatrixXd& response, VectorXd weights)
    : weights_(std::move(weights)),
      matrix_(weights_.size() + 1, weights_.size() + 1),
      scale_(response.cwiseAbs().maxCoeff()),
      force_scale_(scale_ / weights_.maxCoeff()),
      stuck_(to_size(size() + 1), 0),
      position_(to_size(size() + 1), -1) {
  matrix_.topLeftCorner(size(), size()) = response;
  matrix_.rightCols(1).setConstant(scale_);
  stuck_.back() = 1;
  prescribe_force(true);
}

void AdhesionSystem::prescribe_force(bool force) {
  if (force == force_prescribed_) return;
  force_prescribed_ = force;
  matrix_.bottomRows(1).setZero();
  if (force) {
    matrix_.bottomLeftCorner(1, size()) = force_scale_ * weights_.transpose();
  } else {
    matrix_(size(), size()) = scale_;
  }
  base_.clear();
}

void AdhesionSystem::soften(const std::optional<SoftElement>& soft) {
  if (!soft && !soft_) return;
  const bool was_in_base = soft_ && in_base(soft_->element);
  soft_ = soft;
  if (was_in_base || (soft && in_base(soft->element))) base_.clear();
  if (!changes_.empty()) factorise_schur();
}

/// Changes but for a soft element, which nearly always is one.
std::size_t AdhesionSystem::exchanges() const {
  const auto is_exchange = [&](Index i) { return !is_soft(i) || in_base(i); };
  return static_cast<std::size_t>(std::count_if(changes_.begin(), changes_.end(), is_exchange));
}

void AdhesionSystem::follow(const std::vector<Zone>& zones) {
  std::vector<Index> arrivals;
  bool moved = base_.empty();
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const bool stuck = zones[i] == Zone::adhesion;
    if (stuck == (stuck_[i] != 0)) continue;
    stuck_[i] = stuck ? 1 : 0;
    moved = true;
    const auto known = std::find(changes_.begin(), changes_.end(), static_cast<Index>(i));
    if (known == changes_.end()) {
      arrivals.push_back(static_cast<Index>(i));
    } else {
      forget(to_size(known - changes_.begin()));
    }
  }
  if (!moved) {
    // Solves with a border cost as much again as without: in the end, new factors are cheaper.
    if (exchanges() > 0 && ++quiet_rounds_ > base_.size() / 3) factorise();
    return;
  }
  quiet_rounds_ = 0;
  const std::size_t limit = base_.size() / 16 + 8;
  if (base_.empty() || changes_.size() + arrivals.size() > limit) return factorise();
  border(arrivals);
  if (!changes_.empty() && !(factors_rcond_ * schur_factors_.rcond() > least_rcond)) factorise();
}

/// A soft element is left to the border, unless the others would be singular without it: a force
/// needs an element that sticks.
void AdhesionSystem::factorise() {
  changes_.clear();
  base_.clear();
  std::fill(position_.begin(), position_.end(), -1);
  const auto stuck = std::count(stuck_.begin(), stuck_.end(), 1);
  const auto stuck_soft = soft_ ? stuck_[to_size(soft_->element)] : 0;
  const bool leave_out = stuck - 1 > stuck_soft;
  std::vector<Index> left_out;
  for (std::size_t i = 0; i < stuck_.size(); ++i) {
    if (stuck_[i] == 0) continue;
    if (leave_out && is_soft(static_cast<Index>(i))) {
      left_out.push_back(static_cast<Index>(i));
      continue;
    }
    position_[i] = static_cast<Index>(base_.size());
    base_.push_back(static_cast<Index>(i));
  }
  MatrixXd matrix = matrix_(base_, base_);
  if (soft_ && in_base(soft_->element)) {
    const Index at = position(soft_->element);
    matrix(at, at) += soft_->compliance;
  }
  factors_.compute(matrix);
  factors_rcond_ = factors_.rcond();
  columns_.resize(static_cast<Index>(base_.size()), 0);
  schur_.resize(0, 0);
  border(left_out);
}

/// With the compliance of a soft element; its column is divided, or it would spoil the condition.
void AdhesionSystem::factorise_schur() {
  MatrixXd schur = schur_;
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    const auto at = static_cast<Index>(k);
    schur(at, at) += border_softness(changes_[k]);
    schur.col(at) /= border_scale(changes_[k]);
  }
  schur_factors_.compute(schur);
}

/// What the row of a change does to values of the base: all entries of a new element's row, and the
/// value itself of one that left, which must be zero.
double AdhesionSystem::row_of_change(std::size_t change, const VectorXd& base_values) const {
  const Index i = changes_[change];
  if (in_base(i)) return base_values[position(i)];
  return matrix_(i, base_) * base_values;
}

void AdhesionSystem::border(const std::vector<Index>& arrivals) {
  const Index before = static_cast<Index>(changes_.size());
  const Index after = before + static_cast<Index>(arrivals.size());
  columns_.conservativeResize(Eigen::NoChange, after);
  schur_.conservativeResize(after, after);
  for (Index k = before; k < after; ++k) {
    const Index i = arrivals[to_size(k - before)];
    changes_.push_back(i);
    if (in_base(i)) {
      columns_.col(k) = VectorXd::Unit(columns_.rows(), position(i));
    } else {
      columns_.col(k) = matrix_(base_, i);
    }
  }
  if (after > before) {
    columns_.rightCols(after - before) = factors_.solve(columns_.rightCols(after - before)).eval();
  }
  for (Index k = 0; k < after; ++k) {
    for (Index l = k < before ? before : 0; l < after; ++l) {
      const Index i = changes_[to_size(k)], j = changes_[to_size(l)];
      const double corner = in_base(i) || in_base(j) ? 0 : matrix_(i, j);
      schur_(k, l) = corner - row_of_change(to_size(k), columns_.col(l));
    }
  }
  if (after > 0) factorise_schur();
}

/// An element that came or left has gone back.
void AdhesionSystem::forget(std::size_t change) {
  const auto k = static_cast<Index>(change);
  const auto last = static_cast<Index>(changes_.size()) - 1;
  std::swap(changes_[change], changes_.back());
  changes_.pop_back();
  columns_.col(k).swap(columns_.col(last));
  schur_.col(k).swap(schur_.col(last));
  schur_.row(k).swap(schur_.row(last));
  columns_.conservativeResize(Eigen::NoChange, last);
  schur_.conservativeResize(last, last);
}

/// Entries of the right-hand side in slip are ignored, and are zero in the result.
VectorXd AdhesionSystem::solve_bordered(const VectorXd& rhs) const {
  VectorXd all = VectorXd::Zero(rhs.size());
  VectorXd values = rhs(base_);
  if (changes_.empty()) {
    values = factors_.solve(values).eval();
    all(base_) = values;
    return all;
  }
  for (const Index i : changes_) {
    if (in_base(i)) values[position(i)] = 0;
  }
  values = factors_.solve(values).eval();
  VectorXd border(static_cast<Index>(changes_.size()));
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    const double known = in_base(changes_[k]) ? 0 : rhs[changes_[k]];
    border[static_cast<Index>(k)] = known - row_of_change(k, values);
  }
  border = schur_factors_.solve(border).eval();
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    border[static_cast<Index>(k)] /= border_scale(changes_[k]);
  }
  values -= columns_ * border;
  all(base_) = values;
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    const Index i = changes_[k];
    all[i] = in_base(i) ? 0 : border[static_cast<Index>(k)];
  }
  return all;
}

AdhesionSystem::Unknowns AdhesionSystem::solve(const VectorXd& slip, double prescribed) const {
  VectorXd rhs(size() + 1);
  rhs << slip, prescribed * (force_prescribed_ ? force_scale_ : 1);
  VectorXd all = solve_bordered(rhs);
  if (exchanges() > 0) {
    VectorXd rest = rhs - matrix_ * all;
    if (soft_) rest[soft_->element] -= soft_->compliance * all[soft_->element];
    all += solve_bordered(rest);
  }
  return {.increment = all.head(size()), .creepage = scale_ * all[size()]};
}

}  // namespace microslip
