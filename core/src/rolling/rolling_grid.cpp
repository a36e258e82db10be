// SPDX-License-Identifier: GPL-3.0-or-later
#include "rolling_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "contact_grid.hpp"
#include "microslip/support/require.hpp"
#include "remembered/remembered_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

void RollingGrid::fill_state(double distance, const ContactState& contact, double length,
                             const VectorXd& bound, const VectorXd& mean_bound,
                             TransientState& state) const {
  state.distance = distance;
  state.traction = contact.traction;
  state.slip = contact.slip / length;
  state.zones = contact.zones;
  state.force = weights_.dot(contact.traction);
  state.creepage = contact.rigid_slip / length;
  state.end_dissipation = -weights_.cwiseProduct(state.traction).dot(state.slip);
  state.dissipation = state.end_dissipation;
  state.mean_force = state.force;
  state.iterations = contact.iterations;
  state.evidence = evidence_by_elements({weights_, bound, mean_bound, state.traction, state.slip},
                                        state.force, state.creepage);
  state.evidence.residual = contact.residuals.equations;
  if (has_unlike_bodies()) {
    state.evidence.load = weights_.dot(state.traction.cwiseAbs());
    state.evidence.power = std::max(state.evidence.power, state.evidence.dissipated);
  }
  state.adhesion_elements = 0;
  state.slip_elements = 0;
  for (Index i = 0; i < bound.size(); ++i) {
    if (bound[i] <= 0) continue;
    const bool sticks = state.zones[static_cast<std::size_t>(i)] == Zone::adhesion;
    ++(sticks ? state.adhesion_elements : state.slip_elements);
  }
}

void RollingGrid::require_lasting(const ContactScale& scale) const {
  if (!has_unlike_bodies() || scale == ContactScale{}) return;
  throw std::invalid_argument(
      "contact: expected one that stays as it is, as bodies differ in material");
}

void RollingGrid::set_contact(const ContactScale& scale) {
  if (scale == ContactScale{}) return;
  throw std::invalid_argument(
      "scheme: expected 'remembered', which alone rolls on a contact that changes");
}

void RollingGrid::archive(Archive&, bool) {
  throw std::invalid_argument("scheme: expected 'remembered', the state of which alone is saved");
}

double RollingGrid::start_from_shift(const PrescribedForce& force, TransientState& state) {
  const TransientState rest = state;
  const Shift shift = solve_shift(rest, force, state);
  accept_step();
  state.iterations = 0;  // a start is no step
  return shift.distance;
}

Shift RollingGrid::fill_shift(double distance, const VectorXd& before, const ContactState& contact,
                              const VectorXd& slip, const VectorXd& bound,
                              const VectorXd& mean_bound, TransientState& state) const {
  fill_state(distance, contact, 1, bound, mean_bound, state);
  state.slip.setZero();
  state.creepage = 0;
  state.dissipation = 0;
  state.end_dissipation = 0;
  const VectorXd mean_force = weights_.cwiseProduct(before + contact.traction) / 2;
  double above_mean = 0;
  for (Index i = 0; i < bound.size(); ++i) {
    if (bound[i] <= 0 || contact.zones[static_cast<std::size_t>(i)] == Zone::adhesion) continue;
    above_mean -= weights_[i] * (contact.traction[i] - before[i]) / 2 * slip[i];
  }
  return {.distance = contact.rigid_slip,
          .slip = slip,
          .dissipation = above_mean - mean_force.dot(slip),
          .work = above_mean - mean_force.sum() * contact.rigid_slip};
}

void require_no_jacobian(const StepJacobian* jacobian) {
  if (jacobian == nullptr) return;
  throw std::invalid_argument(
      "scheme: expected 'remembered', which alone has derivatives of its steps");
}

VectorXd ratio_to_bound(const TractionBound& bound, const VectorXd& x, const VectorXd& traction) {
  const VectorXd at = bound_at(bound, x);
  return (at.array() > 0).select(traction.array() / at.array(), 0).cwiseMax(-1).cwiseMin(1);
}

std::vector<Zone> zones_at(const VectorXd& traction, const VectorXd& bound) {
  std::vector<Zone> zones;
  for (Index i = 0; i < bound.size(); ++i) {
    const bool sticks = std::abs(traction[i]) < bound[i];
    zones.push_back(sticks            ? Zone::adhesion
                    : traction[i] > 0 ? Zone::slip_positive
                                      : Zone::slip_negative);
  }
  return zones;
}

std::unique_ptr<RollingGrid> rolling_grid(const TransientProblem& problem) {
  const bool remembered = std::holds_alternative<Remembered>(problem.scheme);
  if (!remembered) return std::make_unique<ContactGrid>(problem);
  if (!problem.basis.has_only(constant_shape())) {
    reject("basis", problem.basis.name(), "constant where the material remembers its displacement");
  }
  return std::make_unique<RememberedGrid>(problem);
}

}  // namespace microslip
