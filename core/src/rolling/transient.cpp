// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/transient.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// A start file may have been printed with few digits.
constexpr double printed = 1e-3;

/// A remainder below this part of a step is rounding of the distance.
constexpr double negligible = 1e-9;

ContactState at_rest(const VectorXd& traction, const std::vector<Zone>& zones) {
  return {
      .traction = traction, .slip = VectorXd::Zero(traction.size()), .zones = zones, .creepage = 0};
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

void require_definite(const TransientProblem& problem) {
  const double reach = problem.grid.half_width() + problem.grid.spacing();
  const double definite = definite_half_length(problem.kernel);
  if (definite > reach) return;
  require(false, "kernel.length", definite / 2, [&] {
    return "more than (half_width + dx)/2 = " + format_short(reach / 2) +
           " mm, from where on plane strain resists displacements; below, a creepage would drive "
           "the force the wrong way. Steady rolling takes any length";
  });
}

void require_within_bound(const VectorXd& x, const VectorXd& bound, const VectorXd& traction) {
  const double tolerance = printed * bound.maxCoeff();
  for (Index i = 0; i < x.size(); ++i) {
    require(std::abs(traction[i]) <= bound[i] + tolerance, "traction", traction[i],
            "at most the bound, " + format_short(bound[i]) + ", at x = " + format_short(x[i]));
  }
}

TransientRolling::TransientRolling(const TransientProblem& problem, const Start& start)
    : problem_(problem), spacing_(problem.grid.spacing()), creep_(spacing_) {
  require_definite(problem);
  if (std::holds_alternative<MaterialFixed>(problem.scheme)) {
    if (problem.basis.name() != "constant") {
      reject("basis", problem.basis.name(), "constant on a grid that is fixed to the material");
    }
    material_.emplace(problem.kernel, problem.bound, problem.grid, problem.solver);
    weights_ = VectorXd::Constant(material_->window().size(), spacing_);
  } else {
    make_system();
  }
  if (const auto* shift = std::get_if<CattaneoShift>(&start)) {
    try {
      start_from_shift({shift->force});
    } catch (const BadParameter& error) {
      if (error.key() != "load.force") throw;
      throw BadParameter(shift->key, std::string(shift->key) +
                                         std::string(error.what()).substr(error.key().size()));
    }
  } else {
    const auto* traction = std::get_if<VectorXd>(&start);
    start_from(traction != nullptr ? *traction : VectorXd::Zero(problem.grid.size()));
  }
}

void TransientRolling::make_system() {
  x_ = problem_.grid.nodes();
  bound_ = bound_at(problem_.bound, x_);
  conditions_.bound = bound_;
  weights_ = problem_.basis.weights(spacing_, x_.size());
  mean_bound_ = element_means(problem_.bound, x_, weights_);
  active_set_.emplace(
      influence_operator(problem_.kernel, problem_.basis, spacing_, x_.size(), problem_.solver),
      weights_, problem_.solver);
  advection_.emplace(problem_.kernel, problem_.basis, spacing_, x_.size(), problem_.scheme,
                     problem_.solver);
}

/// Nothing is rolled yet.
void TransientRolling::begin(const ContactState& contact) {
  creep_.start();
  describe(0, contact, 1, bound_, state_);
  state_.element_creepage = 0;
}

void TransientRolling::start_material(const MaterialState& start) {
  x_ = material_->window().x(0);
  bound_ = material_->window().bound(0);
  material_state_ = start;
  begin(start.contact);
}

void TransientRolling::start_from(const VectorXd& traction) {
  const VectorXd nodes = problem_.grid.nodes();
  const VectorXd bound = bound_at(problem_.bound, nodes);
  require_within_bound(nodes, bound, traction);
  if (material_) {
    const VectorXd at = material_->window().x(0);
    const VectorXd ratio =
        (bound.array() > 0).select(traction.array() / bound.array(), 0).cwiseMax(-1).cwiseMin(1);
    start_material(material_->start(
        material_->window().bound(0).cwiseProduct(interpolated(nodes, ratio, at))));
    return;
  }
  std::vector<Zone> zones;
  for (Index i = 0; i < x_.size(); ++i) {
    const bool slips = bound_[i] > 0 && std::abs(traction[i]) >= bound_[i];
    zones.push_back(!slips ? Zone::adhesion
                           : (traction[i] > 0 ? Zone::slip_positive : Zone::slip_negative));
  }
  begin(at_rest(traction, zones));
}

double TransientRolling::start_from_shift(const PrescribedForce& force) {
  if (material_) {
    const auto [start, shift] = material_->shift(force);
    start_material(start);
    return shift;
  }
  const VectorXd zeros = VectorXd::Zero(x_.size());
  const ContactState contact =
      active_set_->solve({.bound = bound_, .offset = zeros, .reference = zeros}, force);
  begin(at_rest(contact.traction, contact.zones));
  return contact.creepage;
}

/// \param contact  with slip displacements, over the length
void TransientRolling::describe(double distance, const ContactState& contact, double length,
                                const VectorXd& bound, TransientState& state) const {
  state.distance = distance;
  state.traction = contact.traction;
  state.slip = contact.slip / length;
  state.zones = contact.zones;
  state.force = weights_.dot(contact.traction);
  state.creepage = contact.creepage / length;
  state.end_dissipation = -weights_.cwiseProduct(state.traction).dot(state.slip);
  state.dissipation = state.end_dissipation;
  state.mean_force = state.force;
  state.iterations = contact.iterations;
  state.evidence = evidence_by_elements(
      {weights_, bound, material_ ? bound : mean_bound_, state.traction, state.slip}, state.force,
      state.creepage);
  state.evidence.residual = contact.residuals.equations;
  state.adhesion_elements = 0;
  state.slip_elements = 0;
  for (Index i = 0; i < bound.size(); ++i) {
    if (bound[i] <= 0) continue;
    const bool sticks = state.zones[static_cast<std::size_t>(i)] == Zone::adhesion;
    ++(sticks ? state.adhesion_elements : state.slip_elements);
  }
}

/// The tractions before are on material that has moved on, beyond the trailing node with the slip
/// there. Slip of relaxed schemes is that over c* dx, whatever the step.
double TransientRolling::contact_dissipation(double length) const {
  const auto* relaxed = std::get_if<Relaxed>(&problem_.scheme);
  const double step_ratio =
      relaxed != nullptr ? relaxed->step_ratio : advection_->solved_step_ratio(length / spacing_);
  double before = 0;
  for (Index i = 0; i < x_.size(); ++i) {
    before -= weights_[i] * state_.traction[i] *
              interpolated(x_, next_.slip, x_[i] - step_ratio * spacing_);
  }
  return (before + next_.end_dissipation) / 2;
}

void TransientRolling::look_ahead_with_contact(double length, const Load& load) {
  const double step_ratio = length / spacing_;
  const double solved_length = advection_->solved_step_ratio(step_ratio) * spacing_;
  advection_->advect(state_.traction, step_ratio, conditions_);
  contact_.zones = state_.zones;
  active_set_->solve(conditions_, over(load, solved_length), contact_);
  const double fraction = advection_->fraction(step_ratio);
  contact_.traction = (1 - fraction) * state_.traction + fraction * contact_.traction;
  describe(state_.distance + length, contact_, solved_length, bound_, next_);
  next_.dissipation = contact_dissipation(length);
  next_.mean_force = (state_.force + next_.force) / 2;
}

void TransientRolling::look_ahead_with_material(double length, const Load& load) {
  const double step_ratio = length / spacing_;
  require(step_ratio >= min_step_ratio, "step.ratio", step_ratio, "a number >= 1e-15");
  MaterialStep& step = material_step_;
  material_->step(material_state_, length, load, step);
  describe(step.end.distance, step.end.contact, length, step.bound, next_);
  next_.dissipation = step.dissipation / length;
  next_.end_dissipation = step.end_dissipation / length;
  next_.mean_force = step.mean_force;
  next_.evidence.backward = step.backward / length;
}

void TransientRolling::look_ahead(double length, const Load& load) {
  if (material_) {
    look_ahead_with_material(length, load);
  } else {
    look_ahead_with_contact(length, load);
  }
  next_.element_creepage = creep_.mean_with(length, next_.creepage);
}

TransientState TransientRolling::attempt(double length, const Load& load) {
  look_ahead(length, load);
  return next_;
}

void TransientRolling::step(double length, const Load& load) {
  look_ahead(length, load);
  std::swap(state_, next_);
  creep_.include(length, state_.creepage);
  if (!material_) return;
  std::swap(material_state_, material_step_.end);
  bound_.swap(material_step_.bound);
  x_ = material_->window().x(material_->phase(material_state_));
}

VectorXd TransientRolling::traction_at_nodes() const {
  return material_ ? material_->values(material_state_) : state_.traction;
}

VectorXd TransientRolling::bound_at_nodes() const { return bound_at(problem_.bound, x_); }

VectorXd TransientRolling::displacement() const {
  return material_ ? material_->displacement(material_state_)
                   : (active_set_->response() * state_.traction);
}

/// The same place, with fewer rounding errors.
void TransientRolling::move_to(double distance) {
  state_.distance = distance;
  material_state_.distance = distance;
  material_state_.distance_error = 0;
}

double TransientRolling::elastic_energy() const {
  const VectorXd& p = state_.traction;
  const VectorXd displacement = material_ ? material_->respond(p) : (active_set_->response() * p);
  return weights_.cwiseProduct(p).dot(displacement) / 2;
}

double TransientRolling::condition() {
  return material_ ? material_->condition() : active_set_->condition();
}

void TransientRolling::roll(double distance, const std::vector<double>& lengths, const Load& load,
                            const std::function<void(const TransientState&)>& after_step) {
  const Schedule schedule(distance, lengths);
  const double start = state_.distance;
  for (std::size_t k = 0;; ++k) {
    step(schedule.length(k), load);
    move_to(start + schedule.end(k));
    after_step(state_);
    if (schedule.is_last(k)) return;
  }
}

std::size_t number_of_steps(double distance, const std::vector<double>& lengths) {
  return Schedule(distance, lengths).size();
}

}  // namespace microslip
