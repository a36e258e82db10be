// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/transient.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// A start file may have been printed with few digits.
constexpr double printed = 1e-3;

/// A remainder below this part of a step is rounding of the distance.
constexpr double negligible = 1e-9;

/// The load of a step, as a slip displacement.
Load over(const Load& load, double length) {
  const auto* creepage = std::get_if<PrescribedCreepage>(&load);
  return creepage == nullptr ? load : PrescribedCreepage{creepage->value * length};
}

/// Steps of given lengths, in turn, the last of which ends at a distance.
class Schedule {
 public:
  Schedule(double distance, const std::vector<double>& lengths)
      : distance_(distance), lengths_(lengths), ends_(lengths.size()) {
    require_positive("motion.distance", distance);
    for (const double length : lengths) require_positive("step length", length);
    std::partial_sum(lengths.begin(), lengths.end(), ends_.begin());
  }

  /// Where step k, from 0, begins.
  double begin(std::size_t k) const { return k == 0 ? 0 : unlimited_end(k - 1); }

  double end(std::size_t k) const { return is_last(k) ? distance_ : unlimited_end(k); }

  double length(std::size_t k) const {
    const double rest = distance_ - begin(k);
    return rest < (1 - negligible) * full_length(k) ? rest : full_length(k);
  }

  bool is_last(std::size_t k) const {
    return distance_ - unlimited_end(k) <= negligible * full_length(k);
  }

  std::size_t size() const {
    const double cycles = std::floor((1 - negligible) * distance_ / ends_.back());
    std::size_t k = static_cast<std::size_t>(cycles) * ends_.size();
    while (!is_last(k)) ++k;
    return k + 1;
  }

 private:
  double full_length(std::size_t k) const { return lengths_[k % lengths_.size()]; }

  double unlimited_end(std::size_t k) const {
    const auto cycles = static_cast<double>(k / ends_.size());
    return cycles * ends_.back() + ends_[k % ends_.size()];
  }

  double distance_;
  const std::vector<double>& lengths_;
  std::vector<double> ends_;
};

}  // namespace

void require_within_bound(const VectorXd& x, const VectorXd& bound, const VectorXd& traction) {
  const double tolerance = printed * bound.maxCoeff();
  for (Index i = 0; i < x.size(); ++i) {
    require(std::abs(traction[i]) <= bound[i] + tolerance, "traction", traction[i],
            "at most the bound, " + format_short(bound[i]) + ", at x = " + format_short(x[i]));
  }
}

TransientRolling::TransientRolling(const TransientProblem& problem, const Start& start)
    : problem_(problem), spacing_(problem.grid.spacing()) {
  if (std::holds_alternative<MaterialFixed>(problem.scheme)) {
    if (problem.basis.name() != "constant") {
      throw std::invalid_argument("basis = '" + problem.basis.name() +
                                  "': expected constant on a grid that is fixed to the material");
    }
    make_window(1);
  } else {
    x_ = problem.grid.nodes();
    bound_ = bound_at(problem.bound, x_);
    make_system(x_.size());
    advection_.emplace(problem.kernel, problem.basis, spacing_, x_.size(), problem.scheme);
  }
  if (const auto* shift = std::get_if<CattaneoShift>(&start)) {
    start_from_shift({shift->force});
  } else {
    const auto* traction = std::get_if<VectorXd>(&start);
    start_from(traction != nullptr ? *traction : VectorXd::Zero(problem.grid.size()));
  }
}

void TransientRolling::make_system(Index size) {
  weights_ = problem_.basis.weights(spacing_, size);
  active_set_.emplace(influence_matrix(problem_.kernel, problem_.basis, spacing_, size), weights_);
}

/// A window with room for steps over so many elements.
void TransientRolling::make_window(Index kept) {
  const auto& scheme = std::get<MaterialFixed>(problem_.scheme);
  window_.emplace(problem_.bound, problem_.grid, scheme.moving_bound, kept);
  make_system(window_->size());
  const Index added = window_->size() - state_.traction.size();
  VectorXd traction = VectorXd::Zero(window_->size());
  traction.tail(state_.traction.size()) = state_.traction;
  state_.traction = std::move(traction);
  state_.zones.insert(state_.zones.begin(), static_cast<std::size_t>(added), Zone::adhesion);
}

void TransientRolling::return_to_start() {
  if (!window_) return;
  x_ = window_->x(0);
  bound_ = window_->bound(0);
}

void TransientRolling::start_from(const VectorXd& traction) {
  return_to_start();
  VectorXd padded = VectorXd::Zero(x_.size());
  padded.tail(traction.size()) = traction;
  require_within_bound(x_, bound_, padded);
  ContactState contact{.traction = padded,
                       .slip = VectorXd::Zero(x_.size()),
                       .zones = {},
                       .creepage = 0,
                       .iterations = 0};
  for (Index i = 0; i < x_.size(); ++i) {
    const bool slips = bound_[i] > 0 && std::abs(padded[i]) >= bound_[i];
    contact.zones.push_back(!slips ? Zone::adhesion
                                   : (padded[i] > 0 ? Zone::slip_positive : Zone::slip_negative));
  }
  state_ = state_of(0, contact, 1, bound_);
}

double TransientRolling::start_from_shift(const PrescribedForce& force) {
  return_to_start();
  const VectorXd zeros = VectorXd::Zero(x_.size());
  ContactState contact =
      active_set_->solve({.bound = bound_, .offset = zeros, .reference = zeros}, force);
  const double shift = std::exchange(contact.creepage, 0);
  contact.slip.setZero();
  state_ = state_of(0, contact, 1, bound_);
  return shift;
}

/// \param contact  with slip displacements, over the length
TransientState TransientRolling::state_of(double distance, const ContactState& contact,
                                          double length, const VectorXd& bound) const {
  TransientState state{.distance = distance,
                       .traction = contact.traction,
                       .slip = contact.slip / length,
                       .zones = contact.zones,
                       .force = weights_.dot(contact.traction),
                       .creepage = contact.creepage / length,
                       .dissipation = 0,
                       .mean_dissipation = std::numeric_limits<double>::quiet_NaN(),
                       .iterations = contact.iterations,
                       .adhesion_elements = 0,
                       .slip_elements = 0};
  state.dissipation = -weights_.cwiseProduct(state.traction).dot(state.slip);
  for (Index i = 0; i < bound.size(); ++i) {
    if (bound[i] <= 0) continue;
    const bool sticks = state.zones[static_cast<std::size_t>(i)] == Zone::adhesion;
    ++(sticks ? state.adhesion_elements : state.slip_elements);
  }
  return state;
}

TransientState TransientRolling::attempt_with_contact(double length, const Load& load) {
  const double step_ratio = length / spacing_;
  const double solved_length = advection_->solved_step_ratio(step_ratio) * spacing_;
  auto [offset, reference] = advection_->advect(state_.traction, step_ratio);
  ContactState contact = active_set_->solve(
      {.bound = bound_, .offset = std::move(offset), .reference = std::move(reference)},
      over(load, solved_length), state_.zones);
  const double fraction = advection_->fraction(step_ratio);
  contact.traction = (1 - fraction) * state_.traction + fraction * contact.traction;
  return state_of(state_.distance + length, contact, solved_length, bound_);
}

/// \param bound  becomes that at the end of the step
TransientState TransientRolling::attempt_with_material(double length, const Load& load,
                                                       VectorXd& bound) {
  const double step_ratio = length / spacing_;
  require(step_ratio >= min_step_ratio, "step.ratio", step_ratio, "a number >= 1e-15");
  const double distance = state_.distance + length;
  const Index elements = window_->elements_between(state_.distance, distance);
  if (elements > window_->kept()) make_window(elements);
  SlipConditions conditions{.bound = window_->bound(distance),
                            .offset = VectorXd::Zero(window_->size()),
                            .reference = moved_on(state_.traction, elements, 0.0)};
  const ContactState contact = active_set_->solve(conditions, over(load, length),
                                                  moved_on(state_.zones, elements, Zone::adhesion));
  TransientState state = state_of(distance, contact, length, conditions.bound);
  const VectorXd mean = (state.traction + conditions.reference) / 2;
  state.mean_dissipation = -weights_.cwiseProduct(mean).dot(state.slip);
  bound = std::move(conditions.bound);
  return state;
}

TransientState TransientRolling::attempt(double length, const Load& load) {
  VectorXd bound;
  return window_ ? attempt_with_material(length, load, bound) : attempt_with_contact(length, load);
}

void TransientRolling::step(double length, const Load& load) {
  if (!window_) {
    state_ = attempt_with_contact(length, load);
    return;
  }
  VectorXd bound;
  state_ = attempt_with_material(length, load, bound);
  x_ = window_->x(state_.distance);
  bound_ = std::move(bound);
}

double TransientRolling::elastic_energy() const {
  return weights_.cwiseProduct(state_.traction).dot(displacement()) / 2;
}

void TransientRolling::roll(double distance, const std::vector<double>& lengths, const Load& load,
                            const std::function<void(const TransientState&)>& after_step) {
  const Schedule schedule(distance, lengths);
  const double start = state_.distance;
  for (std::size_t k = 0;; ++k) {
    step(schedule.length(k), load);
    state_.distance = start + schedule.end(k);
    after_step(state_);
    if (schedule.is_last(k)) return;
  }
}

std::size_t number_of_steps(double distance, const std::vector<double>& lengths) {
  return Schedule(distance, lengths).size();
}

}  // namespace microslip
