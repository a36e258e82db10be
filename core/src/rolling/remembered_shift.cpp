// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <variant>

#include "microslip/halfspace/influence.hpp"
#include "remembered_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

SlipConditions mirrored(const SlipConditions& conditions) {
  SlipConditions mirror = conditions;
  for (VectorXd* of : {&mirror.bound, &mirror.offset, &mirror.reference}) of->reverseInPlace();
  for (CompliantElement& one : mirror.compliant) {
    one.element = conditions.bound.size() - 1 - one.element;
  }
  return mirror;
}

void mirror(RolledContact& rolled) {
  rolled.displacement.reverseInPlace();
  rolled.contact.traction.reverseInPlace();
  rolled.contact.slip.reverseInPlace();
  std::ranges::reverse(rolled.contact.zones);
}

}  // namespace

void RememberedGrid::StandingContact::archive(Archive& archive, Index size) {
  active_set.archive(archive);
  trailing.archive(archive, size);
  leading.archive(archive, size);
}

/// Makes the contact of shifts on first use. The share of the element at the entry is the distance
/// from the edge of the contact to where the scheme feels the end of adhesion without that element.
RememberedGrid::StandingContact& RememberedGrid::standing() {
  if (standing_) return *standing_;
  const Index n = nodes_.size + 1;
  VectorXd x(n);
  x << problem_x_, problem_x_[n - 2] + nodes_.spacing;
  const VectorXd lengths = VectorXd::Constant(n, nodes_.spacing);
  const Kernel kernel = kernel_.is_plane() ? kernel_ : kernel_.in_units_of(response_to_);
  standing_ =
      StandingContact{.bound = element_means(traction_bound_, x, lengths),
                      .active_set = ActiveSet(
                          influence_operator(kernel, constant_basis(), nodes_.spacing, n, solver_),
                          lengths, solver_),
                      .trailing = StickSlipPoint(edge_, exit_share(edge_)),
                      .leading = StickSlipPoint(edge_, entry_share)};
  return *standing_;
}

/// Solves a shift as a step of no length.
Shift RememberedGrid::solve_shift(const TransientState& before, const ShiftLoad& load,
                                  TransientState& after) {
  const bool stays = target_ == state_.scale && target_.carries();
  begin_step(false);
  RememberedState& state = next_.state;
  if (stays) {
    shift_standing(load);
  } else {
    roll({.length = 0, .load = load});
    const bool entered =
        state.entry_has_come(nodes_, edge_.offset) && sticks(state.zones, nodes_.size - 1);
    if (target_.carries() && !entered) state.admit_entry(nodes_);
  }
  const auto* distance = std::get_if<PrescribedShift>(&load);
  sum_.rigid_slip = distance != nullptr ? distance->value : next_.shift;
  sum_.zones = state.zones;
  sum_.traction = state.traction;
  const VectorXd slip =
      stays ? VectorXd(displaced_by(state.traction - state_.traction).array() + sum_.rigid_slip)
            : sum_.slip;
  Shift shift = fill_shift(before.distance, state_.traction, sum_, slip, next_.conditions.bound,
                           next_.conditions.bound, after);
  give_tractions(state, after);
  if (!stays) {
    shift.work = -next_.work;
    shift.dissipation = shift.work - (state.stored - state_.stored);
  }
  return shift;
}

/// Returns the load of the partition. After a turn the mean over partitions differs from the
/// partition by a constant, `before_turn`.
ShiftLoad RememberedGrid::of_standing_partition(const ShiftLoad& load) const {
  const RememberedState& state = next_.state;
  if (const auto* force = std::get_if<PrescribedForce>(&load)) {
    return PrescribedForce{force->value -
                           nodes_.spacing * state.shifts->before_turn.traction.sum()};
  }
  return PrescribedShift{std::get<PrescribedShift>(load).value + state.lead -
                         state.shifts->before_turn.shift};
}

/// Searches the partition of nodes and entry.
/// \param conditions  its offsets are set
/// \return whether material at the trailing end has stuck again
bool RememberedGrid::search_standing(const ShiftLoad& load, SlipConditions& conditions,
                                     ContactState& contact) {
  const Index n = nodes_.size;
  RememberedState& state = next_.state;
  const SubstepEnd end = state.end_of_substep(nodes_, 0, state.distance, state.scale);
  const auto search = [&] {
    for (Index i = 0; i < n; ++i) conditions.offset[i] = -state.remembered_at(i, end);
    conditions.offset[n] = -state.shifts->at_entry;
    if (has_unlike_bodies()) conditions.offset += pressed_.head(n + 1);
    contact.zones = state_.zones;
    contact.zones.push_back(state_.zones.back());
    standing().active_set.solve(conditions, of_standing_partition(load), contact);
    sum_.iterations += contact.iterations;
  };
  search();
  const bool stuck_again = first_stuck(contact.zones) < state.stuck - 1;
  const bool leading_stuck_again =
      state.shifts->leading_kept > 0 && past_last_stuck(contact.zones) > state.shifts->leading + 1;
  if (stuck_again) state.admit_slip(nodes_);
  if (leading_stuck_again) state.admit_leading_slip(nodes_);
  if (stuck_again || leading_stuck_again) search();
  sum_.residuals.equations = contact.residuals.equations;
  return stuck_again;
}

/// Adds the change by the mean over partitions: at the leading end of adhesion, and at both ends.
/// After a turn, the bound of a node is raised by the distance that its traction had from the bound
/// at the turn.
void RememberedGrid::average_standing(const ShiftLoad& load, SlipConditions conditions,
                                      RolledContact rolled) {
  RememberedState& state = next_.state;
  const RolledContact partition = rolled;
  const auto added = [&] {
    MeanChange change{.traction = rolled.contact.traction - partition.contact.traction,
                      .displacement = rolled.displacement - partition.displacement,
                      .shift = rolled.contact.rigid_slip - partition.contact.rigid_slip};
    return change += state.shifts->before_turn;
  };
  const bool has_turned = state.shifts->reversal.size() > 0;
  if (has_turned) {
    const double toward = state.shifts->toward > 0 ? -1 : 1;
    conditions.bound += (conditions.bound + toward * state.shifts->reversal).cwiseMax(0);
  }
  const VectorXd mirrored_reversal = state.shifts->reversal.reverse();
  StandingContact& standing = this->standing();
  mirror(rolled);
  standing.leading.average(standing.active_set, mirrored(conditions), load, rolled, {},
                           has_turned ? &mirrored_reversal : nullptr);
  mirror(rolled);
  state.shifts->leading_mean = added();
  standing.trailing.average(standing.active_set, conditions, load, rolled, {},
                            has_turned ? &state.shifts->reversal : nullptr);
  state.shifts->mean = added();
}

/// Shifts a contact that keeps its size. The nodes and the element at the entry carry traction, and
/// the mean over partitions is taken at either end of adhesion.
void RememberedGrid::shift_standing(const ShiftLoad& load) {
  const Index n = nodes_.size;
  RememberedState& state = next_.state;
  set_response(target_.half_width);
  set_bound(target_);
  const CompliantElement entry{n, spring_.of_mean(entry_share)};
  state.begin_shifts(entry.compliance);
  const auto* force = std::get_if<PrescribedForce>(&load);
  state.go(nodes_, force != nullptr ? nodes_.spacing * state_.traction.sum() - force->value
                                    : std::get<PrescribedShift>(load).value);
  const double entry_before = state.nodes.at[n];

  SlipConditions conditions = {.bound = state.scale.full_sliding() * standing().bound,
                               .offset = VectorXd(n + 1),
                               .reference = VectorXd::Zero(n + 1),
                               .compliant = {exit_, entry},
                               .common = next_.conditions.common};
  RolledContact rolled;
  const bool stuck_again = search_standing(load, conditions, rolled.contact);
  const ContactState& contact = rolled.contact;
  const double moved = contact.rigid_slip;
  rolled.displacement = (contact.slip - conditions.offset).array() - moved;
  state.points.subtract(moved);
  state.shifts->at_entry -= moved;
  state.nodes.at.head(n) = rolled.displacement.head(n);
  press_nodes(state.nodes);
  state.shifts->entry_displaced = rolled.displacement[n];
  if (has_unlike_bodies()) state.shifts->entry_displaced += pressed_[n];
  average_standing(load, conditions, rolled);

  const VectorXd traction = contact.traction + state.shifts->mean.traction;
  state.entry = traction[n];
  state.traction = traction.head(n);
  displace_ends(state.nodes, state.traction, state.entry);
  press_ends(state.nodes);
  state.traction[n - 1] += state.entry;
  next_.shift = moved + state.shifts->mean.shift - state.lead;
  state.lead = state.shifts->mean.shift;
  state.nodes.at[n] += state.lead;
  state.nodes.exit += state.lead;
  state.shifts->entry_slip += state.nodes.at[n] - entry_before + moved;
  state.stored = nodes_.spacing * state.traction.dot(displaced_by(state.traction)) / 2;
  state.remember_shift(nodes_, state.end_of_substep(nodes_, 0, state.distance, state.scale),
                       contact.zones, stuck_again);
}

}  // namespace microslip
