// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_grid.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

ContactGrid::ContactGrid(const TransientProblem& problem)
    : RollingGrid(problem.basis.weights(problem.grid.spacing(), problem.grid.size()),
                  problem.contact.pressure_strain),
      scheme_(problem.scheme),
      spacing_(problem.grid.spacing()),
      active_set_(influence_operator(problem.contact.kernel, problem.basis, spacing_,
                                     problem.grid.size(), problem.solver),
                  weights_, problem.solver),
      traction_bound_(problem.contact.bound),
      advection_(problem.contact.kernel, problem.basis, spacing_, problem.grid.size(),
                 problem.scheme, problem.solver),
      friction_(problem.friction) {
  x_ = problem.grid.nodes();
  bound_ = bound_at(problem.contact.bound, x_);
  mean_bound_ = element_means(problem.contact.bound, x_, weights_);
  conditions_.bound = bound_;
  if (friction_) search_.emplace(friction_->branch);
}

std::unique_ptr<RollingGrid> ContactGrid::clone() const {
  return std::make_unique<ContactGrid>(*this);
}

VectorXd ContactGrid::traction_at_nodes(const TransientState& state) const {
  return state.traction;
}

void ContactGrid::start_from(const VectorXd& traction, TransientState& state) {
  const ContactState contact{.traction = traction,
                             .slip = VectorXd::Zero(x_.size()),
                             .zones = zones_at(traction, bound_),
                             .rigid_slip = 0};
  fill_state(0, contact, 1, bound_, mean_bound_, state);
}

Shift ContactGrid::solve_shift(const TransientState& before, const ShiftLoad& load,
                               TransientState& after) {
  conditions_.bound = bound_;
  conditions_.offset.setZero(x_.size());
  conditions_.reference = before.traction;
  contact_.zones = before.zones;
  active_set_.solve(conditions_, load, contact_);
  return fill_shift(before.distance, before.traction, contact_, contact_.slip, bound_, mean_bound_,
                    after);
}

/// Solves the conditions of a step.
/// \param length  of the step, over which its slip is  [mm]
void ContactGrid::solve_slip(const ShiftLoad& load, double length) {
  if (!friction_) return active_set_.solve(conditions_, load, contact_);
  conditions_.bound = bound_;
  const double time = length / friction_->speed;
  const auto ratio_of = [&](const VectorXd& slip, VectorXd& ratio) {
    for (Index i = 0; i < slip.size(); ++i) {
      ratio[i] = friction_->law(std::abs(slip[i]) / time);
    }
  };
  search_->solve(active_set_, conditions_, load, ratio_of, contact_);
}

void ContactGrid::accept_step() {
  if (search_) ratio_ = search_->ratio();
}

void ContactGrid::set_speed(double speed) {
  if (friction_) friction_->speed = speed;
}

void ContactGrid::solve_step(const TransientState& before, double length, const Load& load,
                             TransientState& after, StepJacobian* jacobian) {
  require_no_jacobian(jacobian);
  require(length > 0, "step_ratio", length / spacing_,
          "a number > 0; the scheme 'remembered' alone rolls back, by ratios below 0");
  const double step_ratio = length / spacing_;
  const double solved_length = advection_.solved_step_ratio(step_ratio) * spacing_;
  advection_.advect(before.traction, step_ratio, conditions_);
  if (has_unlike_bodies()) {
    const VectorXd centres = x_.array() + solved_length / 2;
    conditions_.offset -= pressure_strain_ * solved_length *
                          mean_bound_around(traction_bound_, centres, solved_length);
  }
  contact_.zones = before.zones;
  solve_slip(over_length(load, solved_length), solved_length);
  const double fraction = advection_.fraction(step_ratio);
  contact_.traction = (1 - fraction) * before.traction + fraction * contact_.traction;
  const double end = before.distance + length;
  if (search_) {
    const VectorXd means = mean_bound_.cwiseProduct(search_->ratio());
    fill_state(end, contact_, solved_length, conditions_.bound, means, after);
    after.has_second = search_->has_second();
  } else {
    fill_state(end, contact_, solved_length, bound_, mean_bound_, after);
  }
  after.dissipation = dissipation(before, after, length);
  after.mean_force = (before.force + after.force) / 2;
}

/// Computes the dissipation with mean tractions. The tractions before the step are on material that
/// has moved on; beyond the trailing node they meet the slip of that node. The slip of relaxed
/// schemes is over c* dx, whatever the step.
double ContactGrid::dissipation(const TransientState& before, const TransientState& after,
                                double length) const {
  const auto* relaxed = std::get_if<Relaxed>(&scheme_);
  const double step_ratio =
      relaxed != nullptr ? relaxed->step_ratio : advection_.solved_step_ratio(length / spacing_);
  const double whole = std::floor(step_ratio);
  const double part = step_ratio - whole;
  const Index size = after.slip.size();
  const auto beyond = static_cast<Index>(std::min(whole + 1, static_cast<double>(size)));
  const Index within = size - beyond;
  const auto force_of = [&](Index from, Index nodes) {
    return weights_.segment(from, nodes).cwiseProduct(before.traction.segment(from, nodes));
  };
  const double at_start =
      -after.slip[0] * force_of(0, beyond).sum() -
      (1 - part) *
          force_of(beyond, within).dot(after.slip.segment(std::min<Index>(1, within), within)) -
      part * force_of(beyond, within).dot(after.slip.head(within));
  return (at_start + after.end_dissipation) / 2;
}

}  // namespace microslip
