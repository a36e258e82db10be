// SPDX-License-Identifier: GPL-3.0-or-later
#include "adhesion_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/linalg/index_view.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Least reciprocal condition number of factors and border together. Above this limit refinement
/// recovers the lost digits; below it, new factors are more accurate.
constexpr double least_rcond = 1e-10;

/// Least number of elements for a ToeplitzSubmatrix; with fewer elements LU is as fast. For
/// elements in several intervals, where each solve of the block is iterative, the limit is higher.
constexpr std::size_t small_base = 64;
constexpr std::size_t small_base_in_parts = 160;

/// Each change adds the cost of one product to a Toeplitz solve; new inverses cost about ten such
/// solves.
constexpr std::size_t most_changes_of_block = 16;

/// Number of rounds with adhesion in one interval, and factors of several intervals, before new
/// factors are made.
constexpr std::size_t patience_with_parts = 4;

constexpr int most_refinements = 5;

/// Residual at which GMRES ends, relative to the right-hand side. Refinement gains as many digits
/// again each time.
constexpr double gmres_tolerance = 1e-7;

}  // namespace

AdhesionSystem::AdhesionSystem(LinearOperator response, VectorXd weights, const Solver& solver)
    : response_(std::move(response)),
      weights_(std::move(weights)),
      solver_(solver),
      scale_(response_.largest()),
      force_scale_(scale_ / weights_.maxCoeff()),
      stuck_(to_size(size() + 1), 0),
      position_(to_size(size() + 1), -1),
      block_(response_.block_solver(gmres_tolerance)) {
  stuck_.back() = 1;
}

void AdhesionSystem::prescribe_force(bool force) {
  if (force == force_prescribed_) return;
  force_prescribed_ = force;
  base_.clear();
}

void AdhesionSystem::set_compliant(const std::vector<CompliantElement>& compliant) {
  if (compliant == compliant_) return;
  compliant_ = compliant;
  border_is_new_ = true;
}

double AdhesionSystem::compliance_of(Index i) const {
  for (const auto& [element, compliance] : compliant_) {
    if (element == i) return compliance;
  }
  return 0;
}

/// The contribution of a compliance to the diagonal of the Schur complement.
double AdhesionSystem::corner(Index i) const {
  const double compliance = is_stuck(i) ? compliance_of(i) : 0;
  return in_base(i) && compliance > 0 ? -scale_ * scale_ / compliance : compliance;
}

std::size_t AdhesionSystem::most_changes() const {
  return by_block_ ? most_changes_of_block : base_.size() / 16 + 8;
}

/// An entry of the response, with the added row and column last, as if no element were compliant.
double AdhesionSystem::entry(Index i, Index j) const {
  const Index n = size();
  if (i < n) return j < n ? response_(i, j) : scale_;
  if (force_prescribed_) return j < n ? force_scale_ * weights_[j] : 0;
  return j < n ? 0 : scale_;
}

void AdhesionSystem::follow(const std::vector<Zone>& zones) {
  arrivals_.clear();
  for (std::size_t k = 0; k < zones.size(); ++k) {
    const bool stuck = zones[k] == Zone::adhesion;
    const auto i = static_cast<Index>(k);
    if (stuck != is_stuck(i)) border_is_new_ = true;
    stuck_[k] = stuck ? 1 : 0;
    if (!is_active(i)) continue;
    const auto is_same = [i](const Change& change) { return change.element == i; };
    if (std::none_of(changes_.begin(), changes_.end(), is_same)) arrivals_.push_back(i);
  }
  const auto fits = [&] { return changes_.size() + arrivals_.size() <= most_changes(); };
  if (!fits()) forget_those_gone_back();
  if (base_.empty() || !fits()) return factorise();
  const bool is_new = border_is_new_;
  border(arrivals_);
  const bool spoils = is_new && !changes_.empty() && !(factors_rcond_ * schur_rcond_ > least_rcond);
  if (spoils || serves_too_long()) factorise();
}

/// Whether hard elements in adhesion are in several intervals.
bool AdhesionSystem::adhesion_is_in_parts() const {
  Index first = size(), last = -1, hard = 0;
  for (Index i = 0; i < size(); ++i) {
    if (!is_stuck(i) || compliance_of(i) > 0) continue;
    first = std::min(first, i);
    last = i;
    ++hard;
  }
  return last - first >= hard;
}

/// Solves with a border cost more than solves without one, so that new factors are cheaper in the
/// long run, and much cheaper where solves are iterative without need. Compliant elements do not
/// count, because they would be in the border of new factors, too.
bool AdhesionSystem::serves_too_long() {
  std::size_t patience = by_block_ ? 3 * most_changes_of_block : base_.size() / 3;
  if (by_block_ && base_is_in_parts_ && !adhesion_is_in_parts()) patience = patience_with_parts;
  bool too_long = false;
  for (Change& change : changes_) {
    const bool serves = is_active(change.element) && corner(change.element) == 0;
    change.rounds = serves ? change.rounds + 1 : 0;
    too_long = too_long || change.rounds > patience;
  }
  return too_long;
}

/// Makes new factors. Compliant elements are left to the border, as if they had come later. If no
/// other element sticks, they are in the base, as if they had become compliant later: a prescribed
/// force needs an element that sticks.
void AdhesionSystem::factorise() {
  changes_.clear();
  base_.clear();
  std::fill(position_.begin(), position_.end(), -1);
  const auto is_compliant = [this](Index i) { return compliance_of(i) > 0; };
  const auto sticks_hard = [&](Index i) { return is_stuck(i) && !is_compliant(i); };
  Index hard = 0;
  for (Index i = 0; i < size(); ++i) hard += sticks_hard(i) ? 1 : 0;
  std::vector<Index> compliant;
  for (std::size_t k = 0; k < stuck_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    if (!is_stuck(i)) continue;
    if (is_compliant(i)) compliant.push_back(i);
    if (is_compliant(i) && hard > 0) continue;
    position_[k] = static_cast<Index>(base_.size());
    base_.push_back(i);
  }
  factorise_base();
  make_room();
  border_is_new_ = true;
  border(compliant);
}

/// Allocates memory for the border.
void AdhesionSystem::make_room() {
  const auto most = static_cast<Index>(most_changes());
  rows_.resize(static_cast<Index>(base_.size()), most);
  columns_.resize(static_cast<Index>(base_.size()), most);
  schur_.resize(most, most);
}

void AdhesionSystem::factorise_base() {
  const Index stuck = static_cast<Index>(base_.size()) - 1;
  const std::vector<Index> elements(base_.begin(), base_.end() - 1);
  base_is_in_parts_ = stuck > 0 && elements.back() - elements.front() >= stuck;
  const std::size_t small = base_is_in_parts_ ? small_base_in_parts : small_base;
  by_block_ = block_.has_value() && base_.size() > small;
  if (by_block_) {
    block_->block.choose(elements);
    block_->block.solve(VectorXd::Ones(stuck), unit_slip_);
    base_weights_ = weights_(elements);
    factors_rcond_ = 1;
    return;
  }
  MatrixXd matrix(stuck + 1, stuck + 1);
  matrix.topLeftCorner(stuck, stuck) = response_.block(elements);
  for (Index k = 0; k <= stuck; ++k) {
    matrix(k, stuck) = entry(base_[to_size(k)], size());
    matrix(stuck, k) = entry(size(), base_[to_size(k)]);
  }
  count_work(2.0 / 3 * std::pow(stuck + 1, 3));
  factors_.compute(matrix);
  factors_rcond_ = factors_.rcond();
}

/// Computes the row of a change, at the elements of the base.
void AdhesionSystem::place_row(Index change) {
  const Index i = element(change);
  if (in_base(i)) {
    rows_.col(change) = scale_ * VectorXd::Unit(rows_.rows(), position(i));
    return;
  }
  for (Index l = 0; l < rows_.rows(); ++l) rows_(l, change) = entry(i, base_[to_size(l)]);
}

/// Adds arrivals to the border.
void AdhesionSystem::border(const std::vector<Index>& arrivals) {
  const auto before = static_cast<Index>(changes_.size());
  for (const Index i : arrivals) {
    const auto k = static_cast<Index>(changes_.size());
    changes_.push_back({.element = i});
    place_row(k);
    if (in_base(i)) {
      columns_.col(k) = rows_.col(k);
      continue;
    }
    for (Index l = 0; l < rows_.rows(); ++l) columns_(l, k) = entry(base_[to_size(l)], i);
  }
  const auto after = static_cast<Index>(changes_.size());
  if (by_block_) {
    for (Index k = before; k < after; ++k) {
      values_ = columns_.col(k);
      solve_base(values_);
      columns_.col(k) = values_;
    }
  } else if (after > before) {
    count_work(2 * static_cast<double>((after - before) * columns_.rows() * columns_.rows()));
    auto columns = columns_.middleCols(before, after - before);
    columns = factors_.solve_columns(columns);
  }
  for (Index k = 0; k < after; ++k) {
    for (Index l = k < before ? before : 0; l < after; ++l) {
      const Index i = element(k), j = element(l);
      const double corner = in_base(i) || in_base(j) ? 0 : entry(i, j);
      schur_(k, l) = corner - rows_.col(k).dot(columns_.col(l));
    }
  }
  if (border_is_new_ || after > before) factorise_schur();
}

/// Factorises the Schur complement of the border. Elements that have gone back are decoupled.
/// Columns of compliant elements are scaled, because their large diagonal entries would spoil the
/// condition number.
void AdhesionSystem::factorise_schur() {
  border_is_new_ = false;
  schur_rcond_ = 1;
  const auto n = static_cast<Index>(changes_.size());
  if (n == 0) return;
  count_work(2.0 / 3 * std::pow(n, 3));
  schur_factors_.compute(MatrixXd::NullaryExpr(n, n, [this](Index k, Index l) {
    if (k != l && !(is_active(element(k)) && is_active(element(l)))) return 0.0;
    const double own = k == l ? corner(element(k)) : 0;
    return (schur_(k, l) + own) / border_scale(element(l));
  }));
  schur_rcond_ = schur_factors_.pivot_ratio();
}

void AdhesionSystem::forget_those_gone_back() {
  for (std::size_t k = changes_.size(); k-- > 0;) {
    if (is_active(changes_[k].element)) continue;
    const auto at = static_cast<Index>(k);
    const auto last = static_cast<Index>(changes_.size()) - 1;
    changes_[k] = changes_.back();
    changes_.pop_back();
    rows_.col(at) = rows_.col(last);
    columns_.col(at) = columns_.col(last);
    schur_.col(at) = schur_.col(last);
    schur_.row(at) = schur_.row(last);
  }
}

void AdhesionSystem::solve_base(VectorXd& values) {
  if (by_block_) {
    solve_block(values);
  } else {
    count_work(2 * static_cast<double>(values.size() * values.size()));
    factors_.solve(values, solved_);
    values.swap(solved_);
  }
}

/// Solves for elements and rigid slip: T d = r - (w - constant sum(d)), where T includes the
/// constant.
void AdhesionSystem::solve_block(VectorXd& values) {
  const Index n = values.size() - 1;
  const double prescribed = values[n];
  block_values_ = values.head(n);
  block_->block.solve(block_values_, block_solved_);
  double slip = 0;  // w - constant sum(d)
  if (force_prescribed_) {
    slip = (base_weights_.dot(block_solved_) - prescribed / force_scale_) /
           base_weights_.dot(unit_slip_);
  } else {
    slip = (prescribed - block_->constant * block_solved_.sum()) /
           (1 - block_->constant * unit_slip_.sum());
  }
  values.head(n) = block_solved_ - slip * unit_slip_;
  values[n] = (slip + block_->constant * values.head(n).sum()) / scale_;
}

/// Entries of the right-hand side in slip are ignored, and are zero in the result.
void AdhesionSystem::solve_bordered(const VectorXd& rhs, VectorXd& all) {
  values_ = rhs(index_view(base_));
  for (const Change& change : changes_) {
    const Index i = change.element;
    if (in_base(i) && !is_stuck(i)) values_[position(i)] = 0;
  }
  solve_base(values_);
  const auto changes = static_cast<Index>(changes_.size());
  if (changes > 0) {
    border_.noalias() = -rows_.leftCols(changes).transpose() * values_;
    for (Index k = 0; k < changes; ++k) {
      const Index i = element(k);
      if (!is_active(i)) border_[k] = 0;
      if (is_active(i) && !in_base(i)) border_[k] += rhs[i];
    }
    count_work(4 * static_cast<double>(changes * values_.size()));
    schur_factors_.solve(border_, border_solved_);
    for (Index k = 0; k < changes; ++k) border_solved_[k] /= border_scale(element(k));
    values_.noalias() -= columns_.leftCols(changes) * border_solved_;
  }
  all.setZero(rhs.size());
  all(index_view(base_)) = values_;
  for (Index k = 0; k < changes; ++k) {
    const Index i = element(k);
    if (!is_stuck(i)) {
      all[i] = 0;
    } else if (!in_base(i)) {
      all[i] = border_solved_[k];
    } else if (compliance_of(i) > scale_) {
      all[i] =
          border_solved_[k] * scale_ / compliance_of(i);  // no small difference of large numbers
    }
  }
}

/// Computes the residual of the equations in adhesion and of the added row.
/// \return the largest residual over the largest term
double AdhesionSystem::find_rest(const Unknowns& unknowns) {
  const Index n = size();
  double largest = 0;
  for (Index i = 0; i < n; ++i) {
    if (!is_stuck(i)) continue;
    rest_[i] = rhs_[i] - unknowns.response[i] - unknowns.rigid_slip;
    rest_[i] -= compliance_of(i) * unknowns.increment[i];
    largest = std::max(largest, std::abs(rest_[i]));
  }
  rest_[n] = rhs_[n] - (force_prescribed_ ? force_scale_ * weights_.dot(unknowns.increment)
                                          : unknowns.rigid_slip);
  largest = std::max(largest, std::abs(rest_[n]));
  const double terms =
      std::max({std::abs(unknowns.rigid_slip), rhs_.head(n).lpNorm<Eigen::Infinity>(),
                scale_ * unknowns.increment.lpNorm<Eigen::Infinity>()});
  return terms > 0 ? largest / terms : 0;
}

void AdhesionSystem::solve(const VectorXd& slip, double prescribed, double enough,
                           Unknowns& unknowns) {
  const Index n = size();
  rhs_.resize(n + 1);
  rhs_ << slip, prescribed * (force_prescribed_ ? force_scale_ : 1);
  rest_ = rhs_;
  unknowns.increment.setZero(n);
  unknowns.rigid_slip = 0;
  unknowns.residual = HUGE_VAL;
  for (int refinements = 0;; ++refinements) {
    solve_bordered(rest_, all_);
    unknowns.increment += all_.head(n);
    unknowns.rigid_slip += scale_ * all_[n];
    response_.apply(unknowns.increment, unknowns.response);
    const double before = unknowns.residual;
    unknowns.residual = find_rest(unknowns);
    const bool is_enough = unknowns.residual <= enough * solver_.tolerance;
    if (is_enough || !(unknowns.residual < before / 2) || refinements == most_refinements) return;
  }
}

double AdhesionSystem::condition() {
  if (!changes_.empty()) factorise();
  if (base_.size() < 2) return 1;
  return (by_block_ ? block_->block.condition() : 1 / factors_rcond_) / schur_rcond_;
}

}  // namespace microslip
