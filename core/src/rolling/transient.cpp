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

/// Where step k (from 0) of a cycle of lengths ends.
class Schedule {
 public:
  explicit Schedule(const std::vector<double>& lengths) : ends_(lengths.size()) {
    for (const double length : lengths) require_positive("step length", length);
    std::partial_sum(lengths.begin(), lengths.end(), ends_.begin());
  }

  double end(std::size_t step) const {
    const auto cycles = static_cast<double>(step / ends_.size());
    return cycles * ends_.back() + ends_[step % ends_.size()];
  }

 private:
  std::vector<double> ends_;
};

/// Calls take(length) for each step.
template <class Take>
void for_each_step(double distance, const std::vector<double>& lengths, Take take) {
  require_positive("motion.distance", distance);
  const Schedule schedule(lengths);
  double begin = 0;
  for (std::size_t k = 0;; ++k) {
    const double length = lengths[k % lengths.size()];
    const double rest = distance - begin;
    if (rest <= length * (1 + negligible))
      return take(rest >= length * (1 - negligible) ? length : rest);
    take(length);
    begin = schedule.end(k);
    if (distance - begin <= negligible * length) return;
  }
}

}  // namespace

Index TransientState::adhesion_elements() const {
  return std::count(zones.begin(), zones.end(), Zone::adhesion);
}

Index TransientState::slip_elements() const {
  return static_cast<Index>(zones.size()) - adhesion_elements();
}

TransientRolling::TransientRolling(const TransientProblem& problem)
    : x_(problem.grid.nodes()),
      bound_(bound_at(problem.bound, x_)),
      weights_(problem.basis.weights(problem.grid.spacing(), problem.grid.size())),
      spacing_(problem.grid.spacing()),
      active_set_(influence_matrix(problem.kernel, problem.basis, spacing_, x_.size()), weights_),
      advection_(problem.kernel, problem.basis, spacing_, x_.size(), problem.scheme) {
  start_from(VectorXd::Zero(x_.size()));
}

void TransientRolling::start_from(const VectorXd& traction) {
  const double tolerance = printed * bound_.maxCoeff();
  std::vector<Zone> zones;
  for (Index i = 0; i < x_.size(); ++i) {
    require(std::abs(traction[i]) <= bound_[i] + tolerance, "traction", traction[i],
            "at most the bound " + format_short(bound_[i]) + " at x = " + format_short(x_[i]));
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

void roll(TransientRolling& rolling, double distance, const std::vector<double>& lengths,
          const Load& load, const std::function<void(const TransientState&)>& after_step) {
  for_each_step(distance, lengths, [&](double length) {
    rolling.step(length, load);
    after_step(rolling.state());
  });
}

std::size_t number_of_steps(double distance, const std::vector<double>& lengths) {
  std::size_t count = 0;
  for_each_step(distance, lengths, [&](double) { ++count; });
  return count;
}

}  // namespace microslip
