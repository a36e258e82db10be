// SPDX-License-Identifier: GPL-3.0-or-later
#include "rolling_row.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

#include "../rolling_grid.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// A force this much below full sliding, over full sliding, is that of full sliding.
constexpr double rounding_of_full_sliding = 1e-9;

/// Interpolates to a place of the nodes, in elements from the first.
double turned_at(const RowPoints& points, double at) {
  const double whole = std::floor(at);
  return interpolated_at(points, static_cast<Index>(whole), at - whole, 0);
}

}  // namespace

RollingRow::RollingRow(const TransientProblem& problem)
    : edges_(problem.contact.kernel, problem.grid.spacing()),
      grid_(edges_.nodes(problem.grid.half_width(), problem.grid.size())),
      response_(problem, grid_, edges_),
      stick_slip_point_(edges_.trailing_point()),
      step_(response_, response_.pressed()),
      tangent_(response_) {
  if (problem.friction) friction_.emplace(*problem.friction);
  set_bound({});
}

void RollingRow::set_half_width(double half_width) {
  const int version = response_.version();
  response_.set_half_width(half_width);
  if (response_.version() != version) stick_slip_point_ = edges_.trailing_point();
}

void RollingRow::set_bound(const ContactScale& scale) {
  step_.conditions.bound = scale.full_sliding() * response_.bound();
}

RowMemory RollingRow::started(const VectorXd& traction, const ContactScale& scale) const {
  RowMemory memory(response_.nodes());
  memory.backward = response_.faces_backward();
  const Index n = memory.row.size;
  memory.scale = scale;
  memory.counted_by = scale.half_width;
  memory.traction = traction;
  memory.zones = zones_at(traction, bound());
  if (friction_) memory.friction = {VectorXd::Ones(n + 1), VectorXd::Ones(n)};
  memory.nodes.at.resize(n + 1);
  memory.nodes.at.head(n) = response_.displaced_by(traction);
  response_.displace_ends(memory.nodes, traction, 0);
  memory.stored = memory.row.spacing * traction.dot(memory.nodes.at.head(n)) / 2;
  memory.nodes.at += response_.pressed().head(n + 1);
  memory.nodes.exit += response_.pressed()[n + 1];
  memory.remember_all();
  return memory;
}

void RollingRow::face(bool backward) {
  response_.face(backward);
  step_.imposed = response_.pressed();
}

/// Returns the displacements by the tractions now, without those by the pressure.
RowPoints RollingRow::displacements_of(const RowMemory& memory) const {
  const Index n = memory.row.size;
  VectorXd traction = memory.traction;
  traction[n - 1] -= memory.entry;
  RowPoints points{.at = VectorXd(n + 1)};
  points.at.head(n) = response_.displaced_by(traction) + response_.displaced_by_entry(memory.entry);
  response_.displace_ends(points, traction, memory.entry);
  return points;
}

/// Displacements are interpolated to the places of the mirrored nodes. A solve of no length gives
/// the tractions of the mirrored row, under the same force; in full sliding, where no partition has
/// a force of its own, without a shift. This solve is no slip.
RowMemory RollingRow::turned(const RowMemory& from) {
  const Index n = grid_.size();
  face(!from.backward);
  set_bound(from.scale);
  RowMemory turned = started(VectorXd::Zero(n), from.scale);
  turned.distance = turned.origin = -from.distance;
  turned.distance_error = -from.distance_error;
  if (!from.scale.carries()) return turned;
  set_half_width(from.scale.half_width);
  const RowPoints before = displacements_of(from);
  const double entry_before = -2 * from.row.first;
  for (Index j = 0; j <= n; ++j) {
    turned.nodes.at[j] = -turned_at(before, entry_before - static_cast<double>(j));
  }
  turned.nodes.exit = -turned_at(before, entry_before + 1);
  turned.nodes.at += response_.pressed().head(n + 1);
  turned.nodes.exit += response_.pressed()[n + 1];
  for (Index j = 0; j < n; ++j) {
    const auto i = static_cast<std::size_t>(n - 1 - j);
    turned.zones[static_cast<std::size_t>(j)] = mirrored(from.zones[i]);
  }
  turned.traction = -from.traction.reverse();
  turned.remember_all();
  begin(turned, false);
  const double force = response_.force(turned.traction);
  const bool slides =
      std::abs(force) > (1 - rounding_of_full_sliding) * response_.force(step_.conditions.bound);
  const ShiftLoad held = slides ? ShiftLoad(PrescribedShift{0}) : PrescribedForce{force};
  roll_substep({turned.here(), 0, held, {held, held}, false});
  return step_.memory;
}

void RollingRow::begin(const RowMemory& from, bool with_slopes) {
  face(from.backward);
  step_.begin(from);
  tangent_.begin(from, with_slopes);
  if (friction_) friction_->begin();
  result_.slip.setZero(grid_.size());
  result_.iterations = 0;
  result_.residuals = {};
}

void RollingRow::roll(const Way& way, const RowMemory& from, const ContactScale& target) {
  if (way.length > 0) settle_lead(way.load);
  const double force = response_.force(from.traction);
  step_.memory.distance_error =
      for_each_part(from, step_.memory, way, target, [&](const WayPart& part) {
        roll_substep(substep_of(step_.memory, way, part, from.scale, force, target));
      });
}

/// A contact that begins is at rest at the end of the way, or carries the force.
void RollingRow::replace(const Way& way, const RowMemory& from, const ContactScale& target) {
  const double end = from.distance + way.length;
  const auto* force = std::get_if<PrescribedForce>(&way.load);
  if (target.carries()) {
    set_half_width(target.half_width);
  } else if (force != nullptr) {
    require_carried(force->value, target, 0);
  }
  set_bound(target);
  const double mean_force = response_.force(from.traction) / 2;
  step_.mean_force = mean_force * way.length;
  if (force == nullptr) {
    step_.shift = std::get<PrescribedShift>(way.load).value;
    step_.work = mean_force * step_.shift;
  }
  tangent_.replace(way, mean_force);
  step_.memory = started(VectorXd::Zero(grid_.size()), target);
  step_.memory.distance = step_.memory.origin = end;
  result_.traction = step_.memory.traction;
  if (target.carries() && force != nullptr && force->value != 0) {
    roll_substep({step_.memory.end_of_substep(0, end, target),
                  0,
                  way.load,
                  {PrescribedForce{1}, PrescribedForce{0}},
                  true});
  }
}

/// Moves the partition to the mean over partitions, if a creepage follows a force. This move is no
/// slip.
void RollingRow::settle_lead(const ShiftLoad& load) {
  const RowMemory& memory = step_.memory;
  if (Prescribed(load).by_force || std::abs(memory.lead) <= memory.rounding()) return;
  const PrescribedShift none{0};
  roll_substep({memory.here(), 0, none, {none, none}, false});
  result_.slip.setZero();
}

/// Finds the partition and the tractions for which, with s = S + A p + offset, s = 0 and |p| <= g
/// in adhesion, and |p| = g against s in slip.
void RollingRow::search_partition(const Substep& substep) {
  step_.recall(response_, substep);
  step_.contact.zones = step_.memory.zones;
  if (friction_) {
    friction_->solve(response_.active_set(), step_, substep);
  } else {
    response_.active_set().solve(step_.conditions, step_.of_partition(substep.load), step_.contact);
  }
  result_.iterations += step_.contact.iterations;
}

/// Tells whether the nodes can carry what the element at the entry leaves of a force.
bool RollingRow::nodes_carry(const ShiftLoad& load) const {
  const ShiftLoad left = step_.of_partition(load);
  const auto* force = std::get_if<PrescribedForce>(&left);
  return force == nullptr || std::abs(force->value) < response_.force(bound());
}

void RollingRow::end_entry() {
  step_.entry = 0;
  tangent_.end_entry();
}

/// Reduces the traction at the entry and the relief that the last shift left at the leading edge.
/// If the force needs all of the nodes' bound, both end.
void RollingRow::fade_shift(const Substep& substep) {
  RowMemory& memory = step_.memory;
  const bool is_relieved = memory.relief.size() > 0;
  step_.entry = 0;
  if (memory.entry == 0 && !is_relieved) return;
  const auto [left, slope] = memory.left_of_shift(substep);
  step_.entry = left * memory.entry;
  tangent_.fade(memory, substep.is_last ? slope : 0);
  if (is_relieved) {
    memory.relief *= left;
    step_.conditions.bound -= memory.relief;
    if (left == 0) memory.relief.resize(0);
  }
  if ((step_.entry == 0 && memory.relief.size() == 0) || nodes_carry(substep.load)) return;
  step_.entry = 0;
  memory.relief.resize(0);
  tangent_.end_fading();
  set_bound(substep.scale);
}

/// Adds the slip of a substep. Next to the stick-slip point, a point's slip is counted since its
/// adhesion, so that its earlier slip is subtracted. The earlier slip is interpolated, and on a
/// layer the displacements bend between its places: no more than the slip is subtracted there.
void RollingRow::add_slip(const Substep& substep) {
  const RowMemory& before = step_.memory;
  const ContactState& contact = step_.contact;
  const bool has_layer = response_.kernel().layer_compliance() > 0;
  result_.slip += contact.slip;
  for (Index i = before.kept; i < std::min(before.stuck, before.row.size); ++i) {
    if (sticks(contact.zones, i)) continue;
    const double slipped = interpolated_at(before.nodes, i, substep.on_nodes.of(i), 0) -
                           before.remembered_at(i, substep);
    const bool exceeds = has_layer && slipped * contact.slip[i] > std::pow(contact.slip[i], 2);
    result_.slip[i] -= exceeds ? contact.slip[i] : slipped;
  }
}

/// Rolls a substep, over an element at most.
void RollingRow::roll_substep(const Substep& substep) {
  RowMemory& memory = step_.memory;
  const ContactState& contact = step_.contact;
  set_half_width(substep.scale.half_width);
  set_bound(substep.scale);
  const bool is_relieved = memory.relief.size() > 0;
  fade_shift(substep);
  if (friction_) friction_->take_bound(step_.conditions.bound);
  search_partition(substep);
  if (step_.entry != 0 && !is_relieved && !sticks(contact.zones, memory.row.size - 1)) {
    end_entry();
    search_partition(substep);
  }
  const bool stuck_again = first_stuck(contact.zones) < memory.stuck - 1;
  if (stuck_again) {
    memory.admit_slip();
    tangent_.admit_slip();
    search_partition(substep);
  }
  tangent_.solve(response_, step_, substep);
  double& residual = result_.residuals.equations;
  residual = std::max(residual, contact.residuals.equations);
  add_slip(substep);
  result_.traction = contact.traction;

  step_.displace(response_);
  tangent_.displace(response_);
  const auto slopes = tangent_.contacts();
  stick_slip_point_.average(response_.active_set(), step_.conditions, substep.load, step_,
                            std::span(slopes).first(tangent_.count()));
  if (friction_) friction_->remember(memory, substep, edges_.constants().offset);
  step_.finish(response_, substep, stuck_again);
  if (step_.entry != 0) step_.displacement = response_.displaced_by(memory.traction);
  memory.stored = memory.row.spacing * memory.traction.dot(step_.displacement) / 2;
  step_.mean_force += step_.force * substep.length;
  step_.work += step_.force * step_.creepage - step_.pressed * substep.length;
  tangent_.finish(response_, step_, substep, stuck_again);
}

}  // namespace microslip
