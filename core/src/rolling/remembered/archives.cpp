// SPDX-License-Identifier: GPL-3.0-or-later
#include "../contact_archive.hpp"
#include "microslip/support/archive.hpp"
#include "microslip/support/require.hpp"
#include "remembered_grid.hpp"

namespace microslip {

using Eigen::Index;

namespace {

void archive_points(Archive& archive, RowPoints& points, Index size) {
  archive.numbers("displacements", points.at, size + 1);
  archive.number("displacement_at_exit", points.exit);
}

}  // namespace

void MeanChange::archive(Archive& archive, Index size) {
  archive.numbers("mean_traction", traction, size);
  archive.numbers("mean_displacement", displacement, size);
  archive.number("mean_shift", shift);
}

void ShiftMemory::archive(Archive& archive, Index size) {
  archive.number("toward", toward);
  bool has_turned = reversal.size() > 0;
  archive.flag("has_turned", has_turned);
  if (has_turned) archive.numbers("reversal", reversal, size + 1);
  for (MeanChange* one : {&leading_mean, &mean, &before_turn}) one->archive(archive, size + 1);
  archive.number("at_entry", at_entry);
  archive.number("entry_displaced", entry_displaced);
  archive.number("entry_slip", entry_slip);
  archive.whole("leading", leading, 0, size + 1);
  archive.whole("leading_kept", leading_kept, 0, size + 1);
}

void RememberedFriction::archive(Archive& archive, Index size) {
  archive.numbers("friction_of_points", points, size + 1);
  archive.numbers("friction_at_nodes", nodes, size);
}

void RowMemory::archive(Archive& archive) {
  const Index size = row.size;
  archive.flag("backward", backward);
  archive.number("rolled", distance);
  archive.number("rolled_error", distance_error);
  archive.number("origin", origin);
  archive.number("entered", entered);
  archive_contact(archive, scale);
  archive.number("counted_by", counted_by);
  archive_points(archive, points, size);
  archive_points(archive, nodes, size);
  archive.numbers("tractions", traction, size);
  archive_zones(archive, "zones", zones, size);
  archive.whole("stuck", stuck, 0, size);
  archive.number("stored", stored);
  archive.whole("kept", kept, 0, size);
  archive.number("lead", lead);
  archive.number("entry", entry);
  bool stands = shifts.has_value();
  archive.flag("stands", stands);
  if (stands) (archive.reads() ? shifts.emplace() : *shifts).archive(archive, size);
  bool is_relieved = relief.size() > 0;
  archive.flag("is_relieved", is_relieved);
  if (is_relieved) archive.numbers("relief", relief, size);
  archive.number("ahead", ahead);
}

void RollingRow::archive(Archive& archive) {
  response_.active_set().archive(archive);
  stick_slip_point_.archive(archive, grid_.size());
}

void StandingRow::archive(Archive& archive, Index size) {
  active_set_.archive(archive);
  trailing_.archive(archive, size + 1);
  leading_.archive(archive, size + 1);
}

/// A step begins with `memory_` and overwrites all other members, so `memory_` is all that is
/// stored.
void RememberedGrid::archive(Archive& archive, bool with_solved) {
  ContactScale target = target_;
  double response_to = row_.response().half_width();
  archive_contact(archive, target);
  archive.number("response_to", response_to);
  if (archive.reads()) {
    set_contact(target);
    require_positive("response_to", response_to);
    require_definite(row_.response().kernel(), response_to * reach_);
    row_.set_half_width(response_to);
  }
  row_.archive(archive);
  bool shifted = has_shifted();
  archive.flag("has_shifted", shifted);
  if (shifted) standing().archive(archive, x_.size());
  memory_.archive(archive);
  if (with_solved) row_.step().memory.archive(archive);
  if (row_.friction()) {
    memory_.friction.archive(archive, x_.size());
    if (with_solved) row_.step().memory.friction.archive(archive, x_.size());
  }
  if (!archive.reads()) return;
  place_nodes();
  ratio_ = memory_.friction.nodes;
}

}  // namespace microslip
