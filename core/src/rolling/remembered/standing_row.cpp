// SPDX-License-Identifier: GPL-3.0-or-later
#include "standing_row.hpp"

#include <algorithm>
#include <variant>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

SlipConditions mirrored(const SlipConditions& conditions) {
  SlipConditions mirror = conditions;
  for (VectorXd* of : {&mirror.bound, &mirror.offset, &mirror.reference}) std::ranges::reverse(*of);
  for (CompliantElement& one : mirror.compliant) {
    one.element = conditions.bound.size() - 1 - one.element;
  }
  return mirror;
}

void mirror(RolledContact& rolled) {
  std::ranges::reverse(rolled.displacement);
  std::ranges::reverse(rolled.contact.traction);
  std::ranges::reverse(rolled.contact.slip);
  std::ranges::reverse(rolled.contact.zones);
}

/// Returns the load of the partition. After a turn the mean over partitions differs from the
/// partition by a constant, `before_turn`.
ShiftLoad of_partition(const ShiftLoad& load, const RowMemory& memory) {
  const MeanChange& turned = memory.shifts->before_turn;
  if (const auto* force = std::get_if<PrescribedForce>(&load)) {
    return PrescribedForce{force->value - memory.row.spacing * turned.traction.sum()};
  }
  return PrescribedShift{std::get<PrescribedShift>(load).value + memory.lead - turned.shift};
}

}  // namespace

StandingRow::StandingRow(const RowResponse& response, const RowEdges& edges,
                         const TractionBound& bound, const VectorXd& x)
    : entry_(edges.entry(x.size())),
      version_(response.version()),
      active_set_(response.with_entry()),
      trailing_(edges.trailing_point()),
      leading_(edges.leading_point()) {
  VectorXd with_entry(x.size() + 1);
  with_entry << x, x[x.size() - 1] + response.nodes().spacing;
  bounds_ = {element_means(bound, with_entry, active_set_.weights()),
             mirrored_means(bound, with_entry, active_set_.weights())};
}

/// Searches the partition of nodes and entry.
/// \return whether material at the trailing end has stuck again
bool StandingRow::search(const RowResponse& response, const ShiftLoad& load,
                         const RowMemory& before, RowMemory& memory, ContactState& result) {
  const Index n = memory.row.size;
  const SubstepEnd end = memory.here();
  ContactState& contact = partition_.contact;
  ShiftMemory& shifts = *memory.shifts;
  const auto solve = [&] {
    for (Index i = 0; i < n; ++i) conditions_.offset[i] = -memory.remembered_at(i, end);
    conditions_.offset[n] = -shifts.at_entry;
    conditions_.offset += response.pressed().head(n + 1);
    contact.zones = before.zones;
    contact.zones.push_back(before.zones.back());
    active_set_.solve(conditions_, of_partition(load, memory), contact);
    result.iterations += contact.iterations;
  };
  solve();
  const bool stuck_again = first_stuck(contact.zones) < memory.stuck - 1;
  const bool leading_stuck_again =
      shifts.leading_kept > 0 && past_last_stuck(contact.zones) > shifts.leading + 1;
  if (stuck_again) memory.admit_slip();
  if (leading_stuck_again) shifts.admit_leading_slip(memory);
  if (stuck_again || leading_stuck_again) solve();
  result.residuals.equations = contact.residuals.equations;
  return stuck_again;
}

/// Finds the change by the mean over partitions: at the leading end of adhesion, and at both ends.
/// After a turn, the bound of a node is raised by the distance that its traction had from the bound
/// at the turn.
void StandingRow::average(const ShiftLoad& load, RowMemory& memory) {
  ShiftMemory& shifts = *memory.shifts;
  SlipConditions conditions = conditions_;
  RolledContact mean = partition_;
  const auto added = [&] {
    MeanChange change{.traction = mean.contact.traction - partition_.contact.traction,
                      .displacement = mean.displacement - partition_.displacement,
                      .shift = mean.contact.rigid_slip - partition_.contact.rigid_slip};
    return change += shifts.before_turn;
  };
  const bool has_turned = shifts.reversal.size() > 0;
  if (has_turned) {
    const double toward = shifts.toward > 0 ? -1 : 1;
    conditions.bound += (conditions.bound + toward * shifts.reversal).cwiseMax(0);
  }
  const VectorXd mirrored_reversal = shifts.reversal.reverse();
  mirror(mean);
  leading_.average(active_set_, mirrored(conditions), load, mean, {},
                   has_turned ? &mirrored_reversal : nullptr);
  mirror(mean);
  shifts.leading_mean = added();
  trailing_.average(active_set_, conditions, load, mean, {},
                    has_turned ? &shifts.reversal : nullptr);
  shifts.mean = added();
}

double StandingRow::shift(const RowResponse& response, const ShiftLoad& load,
                          const RowMemory& before, RowMemory& memory, ContactState& result) {
  const Index n = memory.row.size;
  ShiftMemory::begin(memory, entry_.compliance);
  ShiftMemory& shifts = *memory.shifts;
  const auto* force = std::get_if<PrescribedForce>(&load);
  shifts.go(memory, force != nullptr ? response.force(before.traction) - force->value
                                     : std::get<PrescribedShift>(load).value);
  const double entry_before = memory.nodes.at[n];

  conditions_ = {.bound = memory.scale.full_sliding() * bounds_[memory.backward ? 1 : 0],
                 .offset = VectorXd(n + 1),
                 .reference = VectorXd::Zero(n + 1),
                 .compliant = {response.exit(), entry_},
                 .common = response.common()};
  const bool stuck_again = search(response, load, before, memory, result);
  const ContactState& contact = partition_.contact;
  const double moved = contact.rigid_slip;
  partition_.displacement = (contact.slip - conditions_.offset).array() - moved;
  memory.points.subtract(moved);
  shifts.at_entry -= moved;
  memory.nodes.at.head(n) = partition_.displacement.head(n) + response.pressed().head(n);
  shifts.entry_displaced = partition_.displacement[n] + response.pressed()[n];
  average(load, memory);

  const VectorXd traction = contact.traction + shifts.mean.traction;
  memory.entry = traction[n];
  memory.traction = traction.head(n);
  response.displace_ends(memory.nodes, memory.traction, memory.entry);
  memory.nodes.at[n] += response.pressed()[n];
  memory.nodes.exit += response.pressed()[n + 1];
  memory.traction[n - 1] += memory.entry;
  const double shift = moved + shifts.mean.shift - memory.lead;
  memory.lead = shifts.mean.shift;
  memory.nodes.at[n] += memory.lead;
  memory.nodes.exit += memory.lead;
  shifts.entry_slip += memory.nodes.at[n] - entry_before + moved;
  memory.stored =
      memory.row.spacing * memory.traction.dot(response.displaced_by(memory.traction)) / 2;
  shifts.remember(memory, memory.here(), contact.zones, stuck_again);
  return shift;
}

}  // namespace microslip
