// SPDX-License-Identifier: GPL-3.0-or-later
#include "adhesion_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/linalg/index_view.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Factors and border conditioned worse than this together would lose digits that new factors keep:
/// refinement recovers what is lost above it.
constexpr double least_rcond = 1e-10;

/// A ToeplitzBlock of fewer elements is no better than LU.
constexpr std::size_t small_base = 64;

/// Each change costs a Toeplitz solve a product more; new inverses cost some ten such solves.
constexpr std::size_t most_changes_of_block = 16;

constexpr int most_refinements = 5;

std::size_t to_size(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

AdhesionSystem::AdhesionSystem(SquareMatrix response, VectorXd weights, const Solver& solver)
    : response_(std::move(response)),
      weights_(std::move(weights)),
      solver_(solver),
      scale_(response_.largest()),
      force_scale_(scale_ / weights_.maxCoeff()),
      stuck_(to_size(size() + 1), 0),
      position_(to_size(size() + 1), -1) {
  stuck_.back() = 1;
  force_prescribed_ = true;
  if (const Toeplitz* toeplitz = response_.toeplitz()) {
    if (toeplitz->is_symmetric()) constant_ = -(*toeplitz)(size() - 1, 0);
    block_.emplace(toeplitz->plus(constant_), 1e-3 * solver.tolerance);
  }
}

void AdhesionSystem::prescribe_force(bool force) {
  if (force == force_prescribed_) return;
  force_prescribed_ = force;
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

std::size_t AdhesionSystem::most_changes() const {
  return by_block_ ? most_changes_of_block : base_.size() / 16 + 8;
}

/// Of the response with the added row and column last, but for what is soft.
double AdhesionSystem::entry(Index i, Index j) const {
  const Index n = size();
  if (i < n) return j < n ? response_(i, j) : scale_;
  if (force_prescribed_) return j < n ? force_scale_ * weights_[j] : 0;
  return j < n ? 0 : scale_;
}

/// Its entries in the rows of the base.
void AdhesionSystem::column(Index j, Eigen::Ref<VectorXd> values) const {
  for (std::size_t k = 0; k < base_.size(); ++k) {
    values[static_cast<Index>(k)] = entry(base_[k], j);
  }
}

/// What the row of a change does to values of the base: all entries of a new element's row, and the
/// value itself of one that left, which must be zero.
double AdhesionSystem::row_of_change(std::size_t change, const VectorXd& base_values) const {
  const Index i = changes_[change];
  if (in_base(i)) return base_values[position(i)];
  double sum = 0;
  for (std::size_t k = 0; k < base_.size(); ++k) {
    sum += entry(i, base_[k]) * base_values[static_cast<Index>(k)];
  }
  return sum;
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
    const std::size_t patience = by_block_ ? 3 * most_changes_of_block : base_.size() / 3;
    if (exchanges() > 0 && ++quiet_rounds_ > patience) factorise();
    return;
  }
  quiet_rounds_ = 0;
  if (base_.empty() || changes_.size() + arrivals.size() > most_changes()) return factorise();
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
  factorise_base();
  columns_.resize(static_cast<Index>(base_.size()), 0);
  schur_.resize(0, 0);
  border(left_out);
}

void AdhesionSystem::factorise_base() {
  const Index stuck = static_cast<Index>(base_.size()) - 1;
  by_block_ = block_.has_value() && base_.size() > small_base;
  if (by_block_) {
    const std::vector<Index> elements(base_.begin(), base_.end() - 1);
    block_->choose(elements);
    block_->solve(VectorXd::Ones(stuck), unit_slip_);
    base_weights_ = weights_(elements);
    factors_rcond_ = 1;
    return;
  }
  MatrixXd matrix(stuck + 1, stuck + 1);
  const std::vector<Index> elements(base_.begin(), base_.end() - 1);
  matrix.topLeftCorner(stuck, stuck) = response_.block(elements);
  for (Index k = 0; k <= stuck; ++k) {
    matrix(k, stuck) = entry(base_[to_size(k)], size());
    matrix(stuck, k) = entry(size(), base_[to_size(k)]);
  }
  if (soft_ && in_base(soft_->element)) {
    const Index at = position(soft_->element);
    matrix(at, at) += soft_->compliance;
  }
  factors_.compute(matrix);
  factors_rcond_ = factors_.rcond();
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
      column(i, columns_.col(k));
    }
  }
  if (after > before && by_block_) {
    for (Index k = before; k < after; ++k) {
      values_ = columns_.col(k);
      solve_base(values_);
      columns_.col(k) = values_;
    }
  } else if (after > before) {
    columns_.rightCols(after - before) = factors_.solve(columns_.rightCols(after - before)).eval();
  }
  for (Index k = 0; k < after; ++k) {
    for (Index l = k < before ? before : 0; l < after; ++l) {
      const Index i = changes_[to_size(k)], j = changes_[to_size(l)];
      const double corner = in_base(i) || in_base(j) ? 0 : entry(i, j);
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

void AdhesionSystem::solve_base(VectorXd& values) {
  if (by_block_) {
    solve_block(values);
  } else {
    solved_ = factors_.solve(values);
    values.swap(solved_);
  }
}

/// Elements and creepage: T d = r - (w - constant sum(d)), T with the constant.
void AdhesionSystem::solve_block(VectorXd& values) {
  const Index n = values.size() - 1;
  const double prescribed = values[n];
  block_values_ = values.head(n);
  block_->solve(block_values_, block_solved_);
  double slip = 0;  // w - constant sum(d)
  if (force_prescribed_) {
    slip = (base_weights_.dot(block_solved_) - prescribed / force_scale_) /
           base_weights_.dot(unit_slip_);
  } else {
    slip = (prescribed - constant_ * block_solved_.sum()) / (1 - constant_ * unit_slip_.sum());
  }
  values.head(n) = block_solved_ - slip * unit_slip_;
  values[n] = (slip + constant_ * values.head(n).sum()) / scale_;
}

/// Entries of the right-hand side in slip are ignored, and are zero in the result.
void AdhesionSystem::solve_bordered(const VectorXd& rhs, VectorXd& all) {
  values_ = rhs(index_view(base_));
  for (const Index i : changes_) {
    if (in_base(i)) values_[position(i)] = 0;
  }
  solve_base(values_);
  const auto changes = static_cast<Index>(changes_.size());
  if (changes > 0) {
    border_.resize(changes);
    for (Index k = 0; k < changes; ++k) {
      const Index i = changes_[to_size(k)];
      border_[k] = (in_base(i) ? 0 : rhs[i]) - row_of_change(to_size(k), values_);
    }
    border_ = schur_factors_.solve(border_).eval();
    for (Index k = 0; k < changes; ++k) border_[k] /= border_scale(changes_[to_size(k)]);
    values_.noalias() -= columns_ * border_;
  }
  all.setZero(rhs.size());
  all(index_view(base_)) = values_;
  for (Index k = 0; k < changes; ++k) {
    const Index i = changes_[to_size(k)];
    all[i] = in_base(i) ? 0 : border_[k];
  }
}

/// What is left of the right-hand side in adhesion and in the added row.
/// \return the largest of the former over the largest term
double AdhesionSystem::find_rest(const Unknowns& unknowns) {
  const Index n = size();
  double largest = 0;
  for (Index i = 0; i < n; ++i) {
    if (stuck_[to_size(i)] == 0) continue;
    rest_[i] = rhs_[i] - unknowns.response[i] - unknowns.creepage;
    if (is_soft(i)) rest_[i] -= soft_->compliance * unknowns.increment[i];
    largest = std::max(largest, std::abs(rest_[i]));
  }
  rest_[n] = rhs_[n] - (force_prescribed_ ? force_scale_ * weights_.dot(unknowns.increment)
                                          : unknowns.creepage);
  largest = std::max(largest, std::abs(rest_[n]));
  const double terms =
      std::max({std::abs(unknowns.creepage), rhs_.head(n).lpNorm<Eigen::Infinity>(),
                scale_ * unknowns.increment.lpNorm<Eigen::Infinity>()});
  return terms > 0 ? largest / terms : 0;
}

void AdhesionSystem::solve(const VectorXd& slip, double prescribed, Unknowns& unknowns) {
  const Index n = size();
  rhs_.resize(n + 1);
  rhs_ << slip, prescribed * (force_prescribed_ ? force_scale_ : 1);
  rest_ = rhs_;
  unknowns.increment.setZero(n);
  unknowns.creepage = 0;
  unknowns.residual = HUGE_VAL;
  for (int refinements = 0;; ++refinements) {
    solve_bordered(rest_, all_);
    unknowns.increment += all_.head(n);
    unknowns.creepage += scale_ * all_[n];
    response_.apply(unknowns.increment, unknowns.response);
    const double before = unknowns.residual;
    unknowns.residual = find_rest(unknowns);
    const bool enough = unknowns.residual <= 1e-5 * solver_.tolerance;
    if (enough || !(unknowns.residual < before / 2) || refinements == most_refinements) return;
  }
}

}  // namespace microslip
