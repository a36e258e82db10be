// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_step.hpp"

#include <utility>
#include <variant>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

RowStep::RowStep(const RowResponse& response, VectorXd imposed_displacement)
    : memory(response.nodes()), imposed(std::move(imposed_displacement)) {
  const VectorXd zeros = VectorXd::Zero(memory.row.size);
  conditions = {
      .bound = zeros, .offset = zeros, .reference = zeros, .compliant = {response.exit()}};
}

void RowStep::begin(const RowMemory& from) {
  shift = mean_force = work = 0;
  memory = from;
  entry = 0;
}

void RowStep::recall(const RowResponse& response, const SubstepEnd& end) {
  conditions.common = response.common();
  for (Index i = 0; i < memory.row.size; ++i) conditions.offset[i] = -memory.remembered_at(i, end);
  if (entry != 0) conditions.offset += response.displaced_by_entry(entry);
  conditions.offset += imposed.head(memory.row.size);
}

ShiftLoad RowStep::of_partition(const ShiftLoad& load) const {
  if (const auto* prescribed = std::get_if<PrescribedShift>(&load)) {
    return PrescribedShift{prescribed->value + memory.lead};
  }
  return PrescribedForce{std::get<PrescribedForce>(load).value - memory.row.spacing * entry};
}

void RowStep::displace(const RowResponse& response) {
  const Index n = memory.row.size;
  moved = contact.rigid_slip;
  memory.points.subtract(moved);
  displacement = (contact.slip - conditions.offset).array() - moved;
  memory.nodes.at.head(n) = displacement;
  if (entry != 0) memory.nodes.at.head(n) += response.displaced_by_entry(entry);
  memory.nodes.at.head(n) += imposed.head(n);
}

void RowStep::finish(const RowResponse& response, const SubstepEnd& end, bool stuck_again) {
  const Index n = memory.row.size;
  pressed =
      (response.work_of_pressure(memory.traction) + response.work_of_pressure(contact.traction)) /
      2;
  force = memory.row.spacing * (memory.traction.sum() + contact.traction.sum() + entry) / 2;
  creepage = contact.rigid_slip - memory.lead;
  shift += creepage;
  memory.lead = contact.rigid_slip - moved;
  response.displace_ends(memory.nodes, contact.traction, entry);
  memory.nodes.at[n] += imposed[n];
  memory.nodes.exit += imposed[n + 1];
  memory.nodes.at[n] += memory.lead;
  memory.nodes.exit += memory.lead;
  memory.traction = contact.traction;
  memory.traction[n - 1] += entry;
  memory.entry = entry;
  memory.zones = contact.zones;
  memory.scale = end.scale;
  memory.remember(end, stuck_again);
  memory.distance = end.distance;
}

}  // namespace microslip
