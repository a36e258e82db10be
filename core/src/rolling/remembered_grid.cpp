// SPDX-License-Identifier: GPL-3.0-or-later
#include "remembered_grid.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include "load_of_part.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"
#include "remembered_points.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Points that have slipped so many elements ago, or fewer, are kept as if they had not: the
/// partitions whose mean is taken include their nodes in adhesion.
constexpr Index kept_behind = 3;

/// Without rolling, tractions in adhesion are singular at the leading edge, which the scheme then
/// feels half an element nearer. So an element at the entry carries traction, on a spring that is
/// the mean of the solutions with and without it.
constexpr double entry_in_shift = 0.5;

}  // namespace

RememberedGrid::RememberedGrid(const TransientProblem& problem)
    : RememberedGrid(problem, leading_edge_constants(constant_basis())) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge)
    : RememberedGrid(problem, edge,
                     Grid({.half_width = problem.grid.half_width(),
                           .elements = problem.grid.size(),
                           .leading_offset = edge.offset,
                           .trailing_offset = edge.offset - 0.5})) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
                               const Grid& grid)
    : RollingGrid(influence_operator(problem.kernel, constant_basis(), grid.spacing(), grid.size(),
                                     problem.solver),
                  VectorXd::Constant(grid.size(), grid.spacing()), problem.solver),
      traction_bound_(problem.bound),
      problem_nodes_(problem.grid.nodes()),
      spacing_(grid.spacing()),
      edge_(edge),
      kernel_(problem.kernel),
      solver_(problem.solver),
      stick_slip_point_(edge) {
  require_filling(problem.grid, fewest_points, "where the material remembers its displacement");
  const Index n = grid.size();
  x_ = grid.nodes();
  bound_ = element_means(problem.bound, x_, weights_);
  const VectorXd zeros = VectorXd::Zero(n);
  next_.conditions = {.bound = bound_, .offset = zeros, .reference = zeros};
  for (Step& slope : slopes_)
    slope.conditions = {.bound = zeros, .offset = zeros, .reference = zeros};
  entry_influence_.resize(n);
  for (Index j = 0; j < n; ++j) {
    entry_influence_[j] =
        influence(kernel_, constant_shape(), spacing_, static_cast<double>(n - j));
  }
}

std::unique_ptr<RollingGrid> RememberedGrid::clone() const {
  return std::make_unique<RememberedGrid>(*this);
}

VectorXd RememberedGrid::traction_at_nodes(const TransientState& state) const {
  const VectorXd at_nodes = bound_at(traction_bound_, x_);
  VectorXd values(x_.size());
  for (Index i = 0; i < x_.size(); ++i) {
    const Zone zone = state.zones[static_cast<std::size_t>(i)];
    values[i] = zone == Zone::adhesion
                    ? std::clamp(state.traction[i] / edge_.value(x_.size() - 1 - i, 0),
                                 -at_nodes[i], at_nodes[i])
                    : static_cast<double>(zone) * at_nodes[i];
  }
  return values;
}

double RememberedGrid::displacement_at_entry(const VectorXd& traction) const {
  return entry_influence_.dot(traction);
}

/// From tractions that nothing has rolled with.
void RememberedGrid::begin(const VectorXd& traction, TransientState& state) {
  state_ = {};
  state_.traction = traction;
  state_.zones = zones_at(traction, bound_);
  state_.nodes.resize(x_.size() + 1);
  state_.nodes << displacement(traction), displacement_at_entry(traction);
  state_.stored = spacing_ * traction.dot(state_.nodes.head(x_.size())) / 2;
  remember_all(state_);
  fill_state(0, {.traction = traction, .slip = VectorXd::Zero(x_.size()), .zones = state_.zones}, 1,
             bound_, bound_, state);
}

void RememberedGrid::remember_all(RememberedState& state) const {
  state.points = state.nodes;
  state.stuck = first_stuck(state.zones);
  state.kept = state.stuck;
}

/// Takes the ratio of tractions to the bound to the nodes of this grid.
void RememberedGrid::start_from(const VectorXd& traction, TransientState& state) {
  const VectorXd ratio = ratio_to_bound(traction_bound_, problem_nodes_, traction);
  begin(bound_.cwiseProduct(interpolated(problem_nodes_, ratio, x_)), state);
}

double RememberedGrid::start_from_shift(const PrescribedForce& force, TransientState& state) {
  const Index n = x_.size();
  const double distance = RollingGrid::start_from_shift(force, state);
  if (!sticks(state.zones, n - 1)) {
    remember_all(state_);
    return distance;
  }

  VectorXd bound(n + 1);
  bound << bound_, bound_[n - 1];
  const double spring = edge_.compliance * compliance(material_of(kernel_)) * spacing_ *
                        (1 - entry_in_shift) / entry_in_shift;
  ActiveSet with_entry(influence_operator(kernel_, constant_basis(), spacing_, n + 1, solver_),
                       VectorXd::Constant(n + 1, spacing_), solver_);
  const VectorXd zeros = VectorXd::Zero(n + 1);
  const ContactState longer = with_entry.solve(
      {.bound = bound, .offset = zeros, .reference = zeros, .compliant = {{n, spring}}}, force);
  VectorXd traction = longer.traction.head(n);
  traction[n - 1] += longer.traction[n];
  begin(traction, state);
  state_.zones.assign(longer.zones.begin(), longer.zones.end() - 1);
  state_.nodes = with_entry.response() * longer.traction;
  remember_all(state_);
  state.zones = state_.zones;
  return longer.creepage;
}

/// A part of a step that travels nothing.
Shift RememberedGrid::solve_shift(const TransientState& before, const Load& load,
                                  TransientState& after) {
  begin_step(false);
  roll_part(
      {.length = 0, .end = state_.distance, .load = load, .load_slopes = {}, .is_last = true});
  // The point that came to the entry last sticks if it is in the contact and its neighbours do.
  const Index n = x_.size();
  const double now = std::max(0.0, state_.phase(spacing_));
  RememberedState& state = next_.state;
  if (now < 1 - edge_.offset || !sticks(state.zones, n - 1)) {
    state.points[n] = now * state.nodes[n - 1] + (1 - now) * state.nodes[n];
  }
  const auto* distance = std::get_if<PrescribedCreepage>(&load);
  sum_.creepage = distance != nullptr ? distance->value : next_.shift;
  sum_.zones = state.zones;
  sum_.traction = state.traction;
  const VectorXd slip = displacement(state.traction - before.traction).array() + sum_.creepage;
  return fill_shift(before.distance, before.traction, sum_, slip, bound_, bound_, after);
}

void RememberedGrid::begin_step(bool with_slopes) {
  next_.shift = next_.mean_force = next_.work = 0;
  next_.state = state_;
  sum_.slip.setZero(x_.size());
  sum_.iterations = 0;
  sum_.residuals = {};
  has_slopes_ = with_slopes;
  if (!with_slopes) return;
  for (Step& slope : slopes_) {
    slope.shift = slope.mean_force = slope.work = 0;
    slope.state = state_;
    slope.state.points.setZero();
    slope.state.nodes.setZero();
    slope.state.traction.setZero();
    slope.state.stored = 0;
    slope.state.lead = 0;
  }
}

void RememberedGrid::solve_step(const TransientState&, double length, const Load& load,
                                TransientState& after, StepJacobian* jacobian) {
  begin_step(jacobian != nullptr);
  const double force = spacing_ * state_.traction.sum();
  next_.state.distance_error =
      for_each_part(state_, length, spacing_, [&](double part, double end, double rest) {
        const double fraction = 1 - rest / length;
        const bool is_last = rest == 0;
        roll_part({.length = part,
                   .end = end,
                   .load = load_within(load, force, part, fraction),
                   .load_slopes = slopes_within(load, force, part, fraction, length, is_last),
                   .is_last = is_last});
      });

  const RememberedState& state = next_.state;
  sum_.creepage = next_.shift;
  sum_.zones = state.zones;
  fill_state(state.distance, sum_, length, bound_, bound_, after);
  after.traction = state.traction;
  after.force = weights_.dot(state.traction);
  after.mean_force = next_.mean_force / length;
  after.dissipation = -(next_.work + state.stored - state_.stored) / length;
  if (jacobian == nullptr) return;
  jacobian->by_load = slopes_of_step(slopes_[0], after, length, 0);
  jacobian->by_length = slopes_of_step(slopes_[1], after, length, 1);
}
void RememberedGrid::accept_step() { std::swap(state_, next_.state); }

void RememberedGrid::move_to(double distance) { state_.move_to(distance); }

/// The displacement with which the material has come to a node, or its derivative by the way.
/// \param value  interpolated_at or slope_at
template <class Interpolation>
double RememberedGrid::remembered_at(const RememberedState& state, Index i, double phase,
                                     double travelled, const Interpolation& value) const {
  const bool as_if_stuck = i >= state.kept && i < state.stuck;
  if (!sticks(state.zones, i) && !as_if_stuck) return value(state.nodes, i, travelled, 0);
  return value(state.points, i, phase, i >= state.kept ? state.kept : 0);
}

/// \param phase      at the end of the part
/// \param travelled  since the part began  [dx]
void RememberedGrid::recall(Step& step, double phase, double travelled) const {
  for (Index i = 0; i < x_.size(); ++i) {
    step.conditions.offset[i] = -remembered_at(step.state, i, phase, travelled, interpolated_at);
  }
}

/// Points next to the stick-slip point have slipped as they did: they stick again.
void RememberedGrid::admit_slip(RememberedState& state) const {
  const double now = std::max(0.0, state.phase(spacing_));
  for (Index i = state.kept; i < std::min(state.stuck, x_.size()); ++i) {
    state.points[i] =
        i == 0 ? state.nodes[0] : now * state.nodes[i - 1] + (1 - now) * state.nodes[i];
  }
  state.kept = state.stuck;
}

/// Remembers the displacements at the end of the part.
void RememberedGrid::remember(RememberedState& state, double phase, bool stuck_again) const {
  const Index n = x_.size();
  state.stuck = first_stuck(state.zones);
  state.kept = stuck_again ? state.stuck : std::max<Index>(0, state.stuck - kept_behind);
  const auto has_slipped = [&](Index i) {
    return i < n && !sticks(state.zones, i) && (i < state.kept || i > state.stuck);
  };
  if (phase >= 1) {
    std::shift_left(state.points.begin(), state.points.end(), 1);
    state.points[n] = state.nodes[n];
    for (Index i = 0; i < n; ++i) {
      if (has_slipped(i)) state.points[i] = state.nodes[i];
    }
    return;
  }
  if (phase == 0 && has_slipped(0)) state.points[0] = state.nodes[0];
  for (Index i = 1; i < n; ++i) {
    if (!has_slipped(i) || (phase > 0 && sticks(state.zones, i - 1))) continue;
    state.points[i] = phase * state.nodes[i - 1] + (1 - phase) * state.nodes[i];
  }
}

/// Adds the slip of a part. Next to the stick-slip point, slip is counted since a point was in
/// adhesion, so that what it had slipped before has to be taken away.
void RememberedGrid::add_slip(double travelled) {
  const RememberedState& before = next_.state;
  const ContactState& contact = next_.contact;
  sum_.slip += contact.slip;
  for (Index i = before.kept; i < std::min(before.stuck, x_.size()); ++i) {
    if (sticks(contact.zones, i)) continue;
    sum_.slip[i] -= interpolated_at(before.nodes, i, travelled, 0) + next_.conditions.offset[i];
  }
}

/// The load of the partition, which has the lead to make up for.
Load RememberedGrid::of_partition(const Load& load, const Step& step) {
  const auto* creepage = std::get_if<PrescribedCreepage>(&load);
  return creepage == nullptr ? load : PrescribedCreepage{creepage->value + step.state.lead};
}

void RememberedGrid::search_partition(const Load& load) {
  next_.contact.zones = next_.state.zones;
  active_set_.solve(next_.conditions, of_partition(load, next_), next_.contact);
  sum_.iterations += next_.contact.iterations;
}

/// Solves for the derivatives of the contact by the partition that has been found.
void RememberedGrid::solve_slopes(const Part& part, double phase, double travelled) {
  for (std::size_t k = 0; k < 2; ++k) {
    Step& slope = slopes_[k];
    recall(slope, phase, travelled);
    if (k == 1 && part.is_last) {
      for (Index i = 0; i < x_.size(); ++i) {
        slope.conditions.offset[i] -=
            remembered_at(next_.state, i, phase, travelled, slope_at) / spacing_;
      }
    }
    active_set_.solve_partition(slope.conditions, of_partition(part.load_slopes[k], slope),
                                next_.contact.zones, slope.contact);
  }
}

/// The displacements that the partition leads to.
void RememberedGrid::displace(Step& step) const {
  step.moved = step.contact.creepage;
  step.state.points.array() -= step.moved;
  step.displacement = (step.contact.slip - step.conditions.offset).array() - step.moved;
  step.state.nodes.head(x_.size()) = step.displacement;
}

/// Moves to the end of a part, with the mean over partitions.
void RememberedGrid::finish_part(Step& step, const Part& part, double phase,
                                 bool stuck_again) const {
  RememberedState& state = step.state;
  const ContactState& contact = step.contact;
  step.part_force = spacing_ * (state.traction.sum() + contact.traction.sum()) / 2;
  step.creepage = contact.creepage - state.lead;
  step.shift += step.creepage;
  state.lead = contact.creepage - step.moved;
  state.nodes[x_.size()] = displacement_at_entry(contact.traction) + state.lead;
  state.traction = contact.traction;
  state.zones = contact.zones;
  remember(state, phase, stuck_again);
  state.distance = part.end;
  if (phase >= 1) state.entered += 1;
}

/// Rolls up to where an element has been travelled at most.
void RememberedGrid::roll_part(const Part& part) {
  const RememberedState& before = next_.state;
  const double now = part.end / spacing_ - before.entered;
  const double phase = now >= 1 - MaterialWindow::rounding ? 1 : now;
  const double travelled = std::min(1.0, phase - std::max(0.0, before.phase(spacing_)));

  recall(next_, phase, travelled);
  search_partition(part.load);
  const bool stuck_again = first_stuck(next_.contact.zones) < before.stuck - 1;
  const std::size_t slopes = has_slopes_ ? 2 : 0;
  if (stuck_again) {
    admit_slip(next_.state);
    for (std::size_t k = 0; k < slopes; ++k) admit_slip(slopes_[k].state);
    recall(next_, phase, travelled);
    search_partition(part.load);
  }
  if (has_slopes_) solve_slopes(part, phase, travelled);
  double& residual = sum_.residuals.equations;
  residual = std::max(residual, next_.contact.residuals.equations);
  add_slip(travelled);
  sum_.traction = next_.contact.traction;

  displace(next_);
  for (std::size_t k = 0; k < slopes; ++k) displace(slopes_[k]);
  const std::array<RolledContact*, 2> sloped{&slopes_[0], &slopes_[1]};
  stick_slip_point_.average(active_set_, next_.conditions, part.load, next_,
                            std::span(sloped).first(slopes));
  finish_part(next_, part, phase, stuck_again);
  const VectorXd& p = next_.state.traction;
  next_.state.stored = spacing_ * p.dot(next_.displacement) / 2;
  next_.mean_force += next_.part_force * part.length;
  next_.work += next_.part_force * next_.creepage;
  for (std::size_t k = 0; k < slopes; ++k) {
    Step& slope = slopes_[k];
    finish_part(slope, part, phase, stuck_again);
    slope.state.stored =
        spacing_ * (slope.state.traction.dot(next_.displacement) + p.dot(slope.displacement)) / 2;
    slope.mean_force += slope.part_force * part.length;
    if (k == 1 && part.is_last) slope.mean_force += next_.part_force;
    slope.work += slope.part_force * next_.creepage + next_.part_force * slope.creepage;
  }
}

/// \param length     of the step  [mm]
/// \param by_length  its derivative
StepSlopes RememberedGrid::slopes_of_step(const Step& slope, const TransientState& after,
                                          double length, double by_length) const {
  const auto per_length = [&](double of_sum, double value) {
    return (of_sum - value * by_length) / length;
  };
  return {.force = spacing_ * slope.state.traction.sum(),
          .mean_force = per_length(slope.mean_force, after.mean_force),
          .creepage = per_length(slope.shift, after.creepage),
          .dissipation = per_length(-slope.work - slope.state.stored, after.dissipation)};
}

}  // namespace microslip
