// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <variant>

#include "load_of_substep.hpp"
#include "microslip/support/require.hpp"
#include "remembered_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Returns the limit below which slip and shifts are rounding of the displacements  [mm]
double rounding_of(const RememberedState& state) {
  return 1e-13 * state.nodes.at.cwiseAbs().maxCoeff();
}

}  // namespace

void RememberedGrid::solve_step(const TransientState&, double length, const Load& load,
                                TransientState& after, StepJacobian* jacobian) {
  if (length > 0 && std::holds_alternative<PrescribedCreepage>(load)) begin_lost_contact();
  begin_step(jacobian != nullptr);
  roll({.length = length, .load = over_length(load, length)});
  const RememberedState& state = next_.state;
  sum_.rigid_slip = next_.shift;
  sum_.zones = state.zones;
  sum_.slip = (sum_.slip.array().abs() > rounding_of(state)).select(sum_.slip, 0);
  fill_state(state.distance, sum_, length, next_.conditions.bound, next_.conditions.bound, after);
  give_tractions(state, after);
  after.mean_force = next_.mean_force / length;
  after.dissipation = -(next_.work + state.stored - state_.stored) / length;
  if (jacobian == nullptr) return;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  jacobian->by_load = slopes_of_step(slopes_[0], after, length, 0);
  jacobian->by_length = target_ == state_.scale ? slopes_of_step(slopes_[1], after, length, 1)
                                                : StepSlopes{unknown, unknown, unknown, unknown};
}

void RememberedGrid::accept_step() {
  std::swap(state_, next_.state);
  place_nodes();
}

void RememberedGrid::move_to(double distance) { state_.move_to(distance); }

/// Rolls all the way in substeps. A substep ends where an element has been travelled; on a contact
/// that changes, by whichever edge is first.
void RememberedGrid::roll(const Way& way) {
  const RememberedState& from = state_;
  if (from.shifts) {
    set_bound(from.scale);
    next_.state.end_shifts(nodes_, next_.conditions.bound);
  }
  if (!from.scale.carries() || !target_.carries()) return change_contact(way);
  if (way.length > 0) settle_lead(way.load);
  const double width = from.scale.half_width;
  const bool keeps_width = target_.half_width == width;
  if (way.length > 0 && keeps_width && from.counted_by == width) {
    next_.state.distance_error = for_each_substep(
        state_, way.length, nodes_.spacing * width, [&](double substep, double end, double rest) {
          const double begin = 1 - (substep + rest) / way.length;
          roll_substep_to(way, begin, substep, end, {rest == 0 ? 1 : 1 - rest / way.length, false});
        });
    return;
  }
  if (way.length > 0) require_step_ratio(way.length / (nodes_.spacing * width));
  const double added = way.length - from.distance_error;
  const double end = from.distance + added;
  const bool stands = keeps_width && way.length == 0;
  for (double fraction = 0; fraction < 1;) {
    const NextSubstep next = stands ? NextSubstep{1, false}
                                    : next_substep(next_.state, nodes_, fraction, from.distance,
                                                   way.length, from.scale, target_);
    roll_substep_to(way, fraction, (next.end - fraction) * way.length,
                    next.end == 1 ? end : from.distance + next.end * way.length, next);
    fraction = next.end;
  }
  next_.state.distance_error = (end - from.distance) - added;
}

/// Moves the partition to the mean over partitions, if a creepage follows a force. This move is no
/// slip.
void RememberedGrid::settle_lead(const ShiftLoad& load) {
  const RememberedState& state = next_.state;
  if (Prescribed(load).by_force || std::abs(state.lead) <= rounding_of(state)) {
    return;
  }
  const PrescribedShift none{0};
  roll_substep(
      {state.end_of_substep(nodes_, 0, state.distance, state.scale), 0, none, {none, none}, false});
  sum_.slip.setZero();
}

/// Rolls a substep.
/// \param begin     of the substep, as a fraction of the way
/// \param length    of the substep  [mm]
/// \param end       distance at its end  [mm]
void RememberedGrid::roll_substep_to(const Way& way, double begin, double length, double end,
                                     const NextSubstep& next) {
  const double fraction = next.end;
  const ContactScale scale = fraction == 1 ? target_ : between(state_.scale, target_, fraction);
  const bool is_last = fraction == 1;
  const double force = nodes_.spacing * state_.traction.sum();
  const ShiftLoad load = load_of_part(way.load, force, fraction - begin, fraction);
  std::array<ShiftLoad, 2> slopes =
      slopes_of_part(way.load, force, length, fraction, way.length, is_last);
  SubstepEnd substep = next_.state.end_of_substep(nodes_, length, end, scale);
  substep.is_whole = substep.is_whole || next.is_whole;
  roll_substep({substep, length, load, slopes, is_last});
}

/// Begins a contact that was lost and returns within the step where it returns: as a tiny one,
/// which grows on the way. Its material is unstrained.
void RememberedGrid::begin_lost_contact() {
  constexpr double tiny = 1e-9;
  if (state_.scale.carries() || !target_.carries()) return;
  ContactScale first = state_.scale;
  if (!(first.half_width > 0)) first.half_width = tiny * target_.half_width;
  if (!(first.bound > 0)) first.bound = tiny * target_.bound;
  const double distance = state_.distance;
  set_response(first.half_width);
  set_bound(first);
  state_ = start_of(VectorXd::Zero(nodes_.size), first);
  state_.distance = state_.origin = distance;
}

/// Loses the contact; or begins a contact at the end of the way, at rest or with the force.
void RememberedGrid::change_contact(const Way& way) {
  const double end = state_.distance + way.length;
  const auto* force = std::get_if<PrescribedForce>(&way.load);
  if (target_.carries()) {
    set_response(target_.half_width);
  } else if (force != nullptr) {
    require_carried(force->value, target_, 0);
  }
  set_bound(target_);
  const double mean_force = nodes_.spacing * state_.traction.sum() / 2;
  next_.mean_force = mean_force * way.length;
  if (force == nullptr) {
    next_.shift = std::get<PrescribedShift>(way.load).value;
    next_.work = mean_force * next_.shift;
  }
  next_.state = start_of(VectorXd::Zero(nodes_.size), target_);
  next_.state.distance = next_.state.origin = end;
  sum_.traction = next_.state.traction;
  if (target_.carries() && force != nullptr && force->value != 0) {
    roll_substep({next_.state.end_of_substep(nodes_, 0, end, target_), 0, way.load, {}, true});
  }
}

/// Looks up the displacements with which the material has come to the nodes.
void RememberedGrid::recall(Step& step, const Substep& substep) const {
  for (Index i = 0; i < nodes_.size; ++i) {
    step.conditions.offset[i] = -step.state.remembered_at(i, substep);
  }
  if (step.entry != 0) step.conditions.offset += displaced_by_entry(step.entry);
  if (has_unlike_bodies() && &step == &next_) step.conditions.offset += pressed_.head(nodes_.size);
}

/// Adds the slip of a substep. Next to the stick-slip point, a point's slip is counted since its
/// adhesion, so that its earlier slip is subtracted. The earlier slip is interpolated, and on a
/// layer the displacements bend between its places: no more than the slip is subtracted there.
void RememberedGrid::add_slip(const Substep& substep) {
  const RememberedState& before = next_.state;
  const ContactState& contact = next_.contact;
  sum_.slip += contact.slip;
  for (Index i = before.kept; i < std::min(before.stuck, nodes_.size); ++i) {
    if (sticks(contact.zones, i)) continue;
    const double slipped = interpolated_at(before.nodes, i, substep.on_nodes.of(i), 0) -
                           before.remembered_at(i, substep);
    const bool exceeds = has_layer_ && slipped * contact.slip[i] > std::pow(contact.slip[i], 2);
    sum_.slip[i] -= exceeds ? contact.slip[i] : slipped;
  }
}

/// Returns the load of the partition: a shift makes up for the lead, a force is without the
/// element at the entry.
ShiftLoad RememberedGrid::of_partition(const ShiftLoad& load, const Step& step) const {
  const auto* shift = std::get_if<PrescribedShift>(&load);
  if (shift != nullptr) return PrescribedShift{shift->value + step.state.lead};
  return PrescribedForce{std::get<PrescribedForce>(load).value - nodes_.spacing * step.entry};
}

/// Tells whether the nodes can carry what the element at the entry leaves of a force.
bool RememberedGrid::nodes_carry(const ShiftLoad& load) const {
  const ShiftLoad left = of_partition(load, next_);
  const auto* force = std::get_if<PrescribedForce>(&left);
  return force == nullptr || std::abs(force->value) < nodes_.spacing * next_.conditions.bound.sum();
}

/// Ends what the last shift left at the leading edge, where the force needs all of the nodes'
/// bound.
void RememberedGrid::end_fading(const Substep& substep) {
  next_.entry = slopes_[1].entry = 0;
  next_.state.relief.resize(0);
  slopes_[1].conditions.bound.setZero(nodes_.size);
  set_bound(substep.scale);
}

/// Reduces what the last shift left at the leading edge.
void RememberedGrid::fade_shift(const Substep& substep) {
  RememberedState& state = next_.state;
  const bool is_relieved = state.relief.size() > 0;
  next_.entry = 0;
  if (state.entry == 0 && !is_relieved) return;
  const auto [left, slope] = state.left_of_shift(nodes_, substep);
  const double by_length = has_slopes_ && substep.is_last ? slope : 0;
  next_.entry = left * state.entry;
  slopes_[1].entry = by_length * state.entry;
  if (!is_relieved) return;
  slopes_[1].conditions.bound = -by_length * state.relief;
  state.relief *= left;
  next_.conditions.bound -= state.relief;
  if (left == 0) state.relief.resize(0);
}

void RememberedGrid::search_partition(const ShiftLoad& load) {
  next_.contact.zones = next_.state.zones;
  active_set_.solve(next_.conditions, of_partition(load, next_), next_.contact);
  sum_.iterations += next_.contact.iterations;
}

/// Solves for the derivatives of the contact with the partition that has been found.
void RememberedGrid::solve_slopes(const Substep& substep) {
  for (std::size_t k = 0; k < 2; ++k) {
    Step& slope = slopes_[k];
    recall(slope, substep);
    if (k == 1 && substep.is_last) {
      for (Index i = 0; i < nodes_.size; ++i) {
        slope.conditions.offset[i] -= next_.state.slope_at_node(nodes_, i, substep);
      }
    }
    active_set_.solve_partition(slope.conditions, of_partition(substep.load_slopes[k], slope),
                                next_.contact.zones, slope.contact);
  }
}

/// Computes the displacements by the partition's solution.
void RememberedGrid::displace(Step& step) const {
  step.moved = step.contact.rigid_slip;
  step.state.points.subtract(step.moved);
  step.displacement = (step.contact.slip - step.conditions.offset).array() - step.moved;
  step.state.nodes.at.head(nodes_.size) = step.displacement;
  if (step.entry != 0) step.state.nodes.at.head(nodes_.size) += displaced_by_entry(step.entry);
  if (&step == &next_) press_nodes(step.state.nodes);
}

/// Moves to the end of a substep, with the mean over partitions.
void RememberedGrid::finish_substep(Step& step, const Substep& substep, bool stuck_again) const {
  RememberedState& state = step.state;
  const ContactState& contact = step.contact;
  step.substep_pressed =
      (work_of_pressure(state.traction) + work_of_pressure(contact.traction)) / 2;
  step.substep_force =
      nodes_.spacing * (state.traction.sum() + contact.traction.sum() + step.entry) / 2;
  step.creepage = contact.rigid_slip - state.lead;
  step.shift += step.creepage;
  state.lead = contact.rigid_slip - step.moved;
  displace_ends(state.nodes, contact.traction, step.entry);
  if (&step == &next_) press_ends(state.nodes);
  state.nodes.at[nodes_.size] += state.lead;
  state.nodes.exit += state.lead;
  state.traction = contact.traction;
  state.traction[nodes_.size - 1] += step.entry;
  state.entry = step.entry;
  state.zones = contact.zones;
  state.scale = substep.scale;
  state.remember(nodes_, substep, stuck_again);
  state.distance = substep.distance;
}

/// Rolls a substep, over an element at most.
void RememberedGrid::roll_substep(const Substep& substep) {
  const RememberedState& before = next_.state;
  set_response(substep.scale.half_width);
  set_bound(substep.scale);
  const bool all_stuck = before.relief.size() == 0;
  fade_shift(substep);
  const bool fades = next_.entry != 0 || before.relief.size() > 0;
  if (fades && !nodes_carry(substep.load)) end_fading(substep);
  recall(next_, substep);
  search_partition(substep.load);
  if (next_.entry != 0 && all_stuck && !sticks(next_.contact.zones, nodes_.size - 1)) {
    next_.entry = slopes_[1].entry = 0;
    recall(next_, substep);
    search_partition(substep.load);
  }
  const bool stuck_again = first_stuck(next_.contact.zones) < before.stuck - 1;
  const std::size_t slopes = has_slopes_ ? 2 : 0;
  if (stuck_again) {
    next_.state.admit_slip(nodes_);
    for (std::size_t k = 0; k < slopes; ++k) slopes_[k].state.admit_slip(nodes_);
    recall(next_, substep);
    search_partition(substep.load);
  }
  if (has_slopes_) solve_slopes(substep);
  double& residual = sum_.residuals.equations;
  residual = std::max(residual, next_.contact.residuals.equations);
  add_slip(substep);
  sum_.traction = next_.contact.traction;

  displace(next_);
  for (std::size_t k = 0; k < slopes; ++k) displace(slopes_[k]);
  const std::array<RolledContact*, 2> sloped{&slopes_[0], &slopes_[1]};
  stick_slip_point_.average(active_set_, next_.conditions, substep.load, next_,
                            std::span(sloped).first(slopes));
  finish_substep(next_, substep, stuck_again);
  for (std::size_t k = 0; k < slopes; ++k) finish_substep(slopes_[k], substep, stuck_again);
  const VectorXd& p = next_.state.traction;
  if (next_.entry != 0) {
    next_.displacement = displaced_by(p);
    for (std::size_t k = 0; k < slopes; ++k) {
      slopes_[k].displacement = displaced_by(slopes_[k].state.traction);
    }
  }
  next_.state.stored = nodes_.spacing * p.dot(next_.displacement) / 2;
  next_.mean_force += next_.substep_force * substep.length;
  next_.work += next_.substep_force * next_.creepage - next_.substep_pressed * substep.length;
  for (std::size_t k = 0; k < slopes; ++k) {
    Step& slope = slopes_[k];
    slope.state.stored =
        nodes_.spacing *
        (slope.state.traction.dot(next_.displacement) + p.dot(slope.displacement)) / 2;
    slope.mean_force += slope.substep_force * substep.length;
    if (k == 1 && substep.is_last) slope.mean_force += next_.substep_force;
    slope.work += slope.substep_force * next_.creepage + next_.substep_force * slope.creepage -
                  slope.substep_pressed * substep.length;
    if (k == 1 && substep.is_last) slope.work -= next_.substep_pressed;
  }
}

/// Divides the sums of a step by its length, as derivatives.
/// \param length     of the step  [mm]
/// \param by_length  derivative of the length: 1 or 0
StepSlopes RememberedGrid::slopes_of_step(const Step& slope, const TransientState& after,
                                          double length, double by_length) const {
  const auto per_length = [&](double of_sum, double value) {
    return (of_sum - value * by_length) / length;
  };
  return {.force = nodes_.spacing * slope.state.traction.sum(),
          .mean_force = per_length(slope.mean_force, after.mean_force),
          .creepage = per_length(slope.shift, after.creepage),
          .dissipation = per_length(-slope.work - slope.state.stored, after.dissipation)};
}

}  // namespace microslip
