// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/transient.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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

Index TransientState::adhesion_elements() const {
  return std::count(zones.begin(), zones.end(), Zone::adhesion);
}

Index TransientState::slip_elements() const {
  return static_cast<Index>(zones.size()) - adhesion_elements();
}

void require_within_bound(const VectorXd& x, const VectorXd& bound, const VectorXd& traction) {
  const double tolerance = printed * bound.maxCoeff();
  for (Index i = 0; i < x.size(); ++i) {
    require(std::abs(traction[i]) <= bound[i] + tolerance, "traction", traction[i],
            "at most the bound, " + format_short(bound[i]) + ", at x = " + format_short(x[i]));
  }
}

TransientRolling::TransientRolling(const TransientProblem& problem, const Start& start)
    : x_(problem.grid.nodes()),
      bound_(bound_at(problem.bound, x_)),
      weights_(problem.basis.weights(problem.grid.spacing(), problem.grid.size())),
      spacing_(problem.grid.spacing()),
      active_set_(influence_matrix(problem.kernel, problem.basis, spacing_, x_.size()), weights_),
      advection_(problem.kernel, problem.basis, spacing_, x_.size(), problem.scheme) {
  if (const auto* shift = std::get_if<CattaneoShift>(&start)) {
    start_from_shift({shift->force});
  } else {
    const auto* traction = std::get_if<VectorXd>(&start);
    start_from(traction != nullptr ? *traction : VectorXd::Zero(x_.size()));
  }
}

void TransientRolling::start_from(const VectorXd& traction) {
  require_within_bound(x_, bound_, traction);
  std::vector<Zone> zones;
  for (Index i = 0; i < x_.size(); ++i) {
    const bool slips = bound_[i] > 0 && std::abs(traction[i]) >= bound_[i];
    zones.push_back(!slips ? Zone::adhesion
                           : (traction[i] > 0 ? Zone::slip_positive : Zone::slip_negative));
  }
  state_ = {.distance = 0,
            .traction = traction,
            .slip = VectorXd::Zero(x_.size()),
            .zones = zones,
            .force = weights_.dot(traction),
            .creepage = 0,
            .dissipation = 0,
            .iterations = 0};
}

double TransientRolling::start_from_shift(const PrescribedForce& force) {
  const VectorXd zeros = VectorXd::Zero(x_.size());
  const ContactState contact =
      active_set_.solve({.bound = bound_, .offset = zeros, .reference = zeros}, force);
  start_from(contact.traction);
  state_.zones = contact.zones;
  state_.iterations = contact.iterations;
  return contact.creepage;
}

void TransientRolling::step(double length, const Load& load) {
  const double step_ratio = length / spacing_;
  const double solved_length = advection_.solved_step_ratio(step_ratio) * spacing_;
  auto [offset, reference] = advection_.advect(state_.traction, step_ratio);
  ContactState contact = active_set_.solve(
      {.bound = bound_, .offset = std::move(offset), .reference = std::move(reference)},
      over(load, solved_length), state_.zones);
  const double fraction = advection_.fraction(step_ratio);
  contact.traction = (1 - fraction) * state_.traction + fraction * contact.traction;
  const VectorXd slip = contact.slip / solved_length;
  state_ = {.distance = state_.distance + length,
            .traction = contact.traction,
            .slip = slip,
            .zones = contact.zones,
            .force = weights_.dot(contact.traction),
            .creepage = contact.creepage / solved_length,
            .dissipation = -weights_.cwiseProduct(contact.traction).dot(slip),
            .iterations = contact.iterations};
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
