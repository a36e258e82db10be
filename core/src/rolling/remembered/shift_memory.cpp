// SPDX-License-Identifier: GPL-3.0-or-later
#include "shift_memory.hpp"

#include <algorithm>

#include "row_edges.hpp"
#include "row_memory.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// So many nodes in adhesion next to its leading end may slip in the mean over partitions.
constexpr Index averaged = 2;

/// Shares the slip at the entry between the last point and the next one. The scheme feels the edge
/// of a shift, at which tractions are singular, `offset` - 1/2 elements ahead of the last point
/// that sticks. So the fraction t of the last point sticks, and the fraction t - 1 of the next
/// point, which is not remembered yet.
/// \param slip  at the entry, of material that is outside  [mm]
void share_slip(RowMemory& memory, double slip) {
  const Index n = memory.row.size;
  const double inside = memory.among_points().of(n) + 0.5;
  memory.points.at[n] += std::max(0.0, 1 - inside) * slip;
  memory.ahead += std::max(0.0, inside - 1) * slip;
}

}  // namespace

MeanChange& MeanChange::operator+=(const MeanChange& other) {
  traction += other.traction;
  displacement += other.displacement;
  shift += other.shift;
  return *this;
}

void ShiftMemory::begin(RowMemory& memory, double spring) {
  if (memory.shifts) return;
  const VectorXd none = VectorXd::Zero(memory.row.size + 1);
  ShiftMemory& begun = memory.shifts.emplace();
  begun.before_turn = {.traction = none, .displacement = none};
  begun.at_entry = memory.nodes.at[memory.row.size] + spring * memory.entry;
}

void ShiftMemory::go(RowMemory& memory, double sign) {
  const bool turns = sign * toward < 0;
  if (sign != 0) toward = sign;
  if (!turns) return;
  const Index n = memory.row.size;
  reversal.resize(n + 1);
  reversal << memory.traction, memory.entry;
  reversal[n - 1] -= memory.entry;
  reversal -= mean.traction;
  memory.admit_slip();
  admit_leading_slip(memory);
  before_turn = mean;
}

void ShiftMemory::remember(RowMemory& memory, const SubstepEnd& end,
                           const std::vector<Zone>& with_entry, bool stuck_again) {
  const Index n = memory.row.size;
  memory.zones.assign(with_entry.begin(), with_entry.end() - 1);
  leading = past_last_stuck(with_entry);
  leading_kept = std::min(n, leading + kept_behind) + 1;
  if (leading_kept <= n) at_entry = entry_displaced;
  memory.remember(end, stuck_again);
}

void ShiftMemory::admit_leading_slip(RowMemory& memory) {
  memory.slip_points(leading, std::min(leading_kept, memory.row.size));
  at_entry = entry_displaced;
  leading_kept = leading;
}

void ShiftMemory::end(RowMemory& memory, const VectorXd& bound) {
  const ShiftMemory& shifts = *memory.shifts;
  const Index n = memory.row.size;
  const Index leading = shifts.leading;
  const double shift = shifts.leading_mean.shift;
  RowPoints& nodes = memory.nodes;
  memory.points.subtract(shift);
  nodes.at.head(n) += shifts.leading_mean.displacement.head(n);
  nodes.at[n] -= shift;
  nodes.exit -= shift;
  memory.lead -= shift;
  memory.slip_points(std::max(memory.kept, leading - averaged), std::min(shifts.leading_kept, n));
  if (leading > n) {
    share_slip(memory, shifts.entry_slip / (1 - RowEdges::entry_share));
  } else {
    memory.admit_entry();
  }
  if (leading < n) {
    VectorXd& relief = memory.relief;
    relief = VectorXd::Zero(n);
    const Index slipping = n - leading;
    relief.tail(slipping) = memory.traction.tail(slipping);
    relief[n - 1] -= memory.entry;
    relief.tail(slipping) = bound.tail(slipping) - relief.tail(slipping).cwiseAbs();
  }
  memory.shifts.reset();
}

}  // namespace microslip
