// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/material_rolling.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/halfspace/influence.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Closer points of the history would only cost memory  [dx]
constexpr double history_resolution = 1e-3;

Zone& at(std::vector<Zone>& zones, Index i) { return zones[static_cast<std::size_t>(i)]; }

double direction(Zone zone) { return static_cast<double>(zone); }

/// The load of a part of a step, as a slip displacement.
Load over(const Load& load, double length) {
  const auto* creepage = std::get_if<PrescribedCreepage>(&load);
  return creepage == nullptr ? load : PrescribedCreepage{creepage->value * length};
}

}  // namespace

void Approach::advance(double phase, double coming_slip, double ahead_slip) {
  coming_ += coming_slip;
  const double ahead = (ahead_.empty() ? 0 : ahead_.back().slip) + ahead_slip;
  const double last_but_one = ahead_.size() < 2 ? 0 : ahead_[ahead_.size() - 2].phase;
  const bool close = !ahead_.empty() && phase - last_but_one < history_resolution;
  if (close) ahead_.pop_back();
  ahead_.push_back({phase, ahead});
}

void Approach::enter() {
  before_ = std::move(ahead_);
  ahead_.clear();
  coming_ = before_.empty() ? 0 : before_.back().slip;
}

double Approach::since_one_element_before(double phase) const {
  Point from{0, 0};
  for (const Point& to : before_) {
    if (phase < to.phase) {
      const double part = (phase - from.phase) / (to.phase - from.phase);
      return coming_ - ((1 - part) * from.slip + part * to.slip);
    }
    from = to;
  }
  return coming_ - from.slip;
}

MaterialRolling::MaterialRolling(const Kernel& kernel, const TractionBound& bound, const Grid& grid)
    : MaterialRolling(kernel, bound, grid, leading_edge_constants(constant_basis())) {}

MaterialRolling::MaterialRolling(const Kernel& kernel, const TractionBound& bound, const Grid& grid,
                                 const LeadingEdgeConstants& edge)
    : bound_(bound),
      window_(bound, grid, edge.offset),
      edge_(edge),
      compliance_(edge.compliance * compliance(material_of(kernel)) * window_.spacing()),
      active_set_(influence_matrix(kernel, constant_basis(), window_.spacing(), window_.size()),
                  VectorXd::Constant(window_.size(), window_.spacing())),
      defect_(kernel, bound, window_) {}

double MaterialRolling::phase(const MaterialState& state) const {
  return state.distance / window_.spacing() - state.entered;
}

VectorXd MaterialRolling::respond(const VectorXd& traction) const {
  return active_set_.respond(traction);
}

VectorXd MaterialRolling::values(const MaterialState& state) const {
  const double part = std::max(0.0, phase(state));
  const VectorXd mean = window_.bound(part);
  const VectorXd at_nodes = bound_at(bound_, window_.x(part));
  VectorXd values = VectorXd::Zero(window_.size());
  for (Index i = 0; i <= window_.coming(); ++i) {
    if (at_nodes[i] <= 0) continue;
    const Zone zone = state.zones[static_cast<std::size_t>(i)];
    const double sliding = direction(zone) != 0 ? direction(zone) : state.sliding_direction;
    const double adhesion = state.traction[i] - sliding * mean[i];
    values[i] = sliding * at_nodes[i];
    if (zone == Zone::adhesion) values[i] += adhesion / edge_.value(window_.leading() - i, part);
  }
  return values;
}

std::optional<SoftElement> MaterialRolling::soft_element(double phase) const {
  if (phase <= MaterialWindow::rounding) return std::nullopt;
  return SoftElement{window_.coming(), compliance_ * (1 - phase) / phase};
}

double MaterialRolling::trailing_direction(const VectorXd& bound,
                                           const std::vector<Zone>& zones) const {
  Index i = 0;
  while (i < window_.leading() && bound[i] <= 0) ++i;
  return direction(zones[static_cast<std::size_t>(i)]);
}

MaterialState MaterialRolling::start(const VectorXd& traction) const {
  const VectorXd bound = window_.bound(0);
  MaterialState state{.distance = 0,
                      .entered = 0,
                      .traction = traction,
                      .zones = {},
                      .sliding_direction = 0,
                      .approach = {}};
  for (Index i = 0; i < bound.size(); ++i) {
    const bool slips = std::abs(traction[i]) >= bound[i];
    state.zones.push_back(!slips ? Zone::adhesion
                                 : (traction[i] > 0 ? Zone::slip_positive : Zone::slip_negative));
  }
  state.sliding_direction = trailing_direction(bound, state.zones);
  return state;
}

MaterialRolling::Shifted MaterialRolling::shift(const PrescribedForce& force) {
  MaterialState state = start(VectorXd::Zero(window_.size()));
  const double sign = force.value > 0 ? 1 : (force.value < 0 ? -1 : 0);
  const auto respond_to = [&](const VectorXd& traction) { return respond(traction); };
  const SlipConditions conditions{.bound = window_.bound(0),
                                  .offset = sign * defect_.at(0, respond_to),
                                  .reference = state.traction};
  const ContactState contact = active_set_.solve(conditions, force, state.zones);
  state.traction = contact.traction;
  state.zones = contact.zones;
  state.sliding_direction = trailing_direction(conditions.bound, state.zones);
  return {std::move(state), contact.creepage};
}

MaterialStep MaterialRolling::step(const MaterialState& from, double length, const Load& load) {
  MaterialStep step{.end = from,
                    .bound = {},
                    .slip = VectorXd::Zero(window_.size()),
                    .creepage = 0,
                    .dissipation = 0,
                    .mean_dissipation = 0,
                    .mean_force = 0,
                    .iterations = 0};
  const double end = from.distance + length;
  double rest = length;
  for (double next = from.entered + 1; end / window_.spacing() - next > MaterialWindow::rounding;
       ++next) {
    const double part = next * window_.spacing() - step.end.distance;
    roll_part(step, part, next * window_.spacing(), load);
    rest -= part;
  }
  roll_part(step, rest, end, load);
  step.mean_force /= length;
  return step;
}

/// Up to the next node's entrance at most.
void MaterialRolling::roll_part(MaterialStep& step, double length, double end, const Load& load) {
  MaterialState& state = step.end;
  const double phase_before = phase(state);
  const bool enters = end / window_.spacing() - state.entered >= 1 - MaterialWindow::rounding;
  const Index moved = enters ? 1 : 0;
  state.distance = end;
  state.entered += enters ? 1 : 0;
  const double phase_now = phase(state);

  const VectorXd before = moved_on(state.traction, moved, 0.0);
  std::vector<Zone> zones = moved_on(state.zones, moved, Zone::slip_negative);
  const auto soft = soft_element(phase_now);
  const bool was_out = phase_before <= MaterialWindow::rounding;
  if (enters && was_out) at(zones, window_.leading()) = Zone::adhesion;
  if (soft && was_out) at(zones, window_.coming()) = Zone::adhesion;

  const auto respond_to = [&](const VectorXd& traction) { return respond(traction); };
  SlipConditions conditions{.bound = window_.bound(phase_now),
                            .offset = VectorXd::Zero(window_.size()),
                            .reference = before,
                            .soft = soft};
  if (state.sliding_direction != 0) {
    conditions.offset = state.sliding_direction *
                        defect_.change(phase_before, phase_now, moved, length, respond_to);
  }
  // The condition of a node that comes or enters is about the last element travelled.
  const Index edge = enters ? window_.leading() : window_.coming();
  double added = 0;
  if (enters || soft) added = state.approach.since_one_element_before(enters ? 1 : phase_now);
  if (soft) added -= soft->compliance * state.sliding_direction * conditions.bound[edge];
  conditions.offset[edge] += added;

  ContactState contact = active_set_.solve(conditions, over(load, length), zones);
  state.traction = contact.traction;
  state.zones = contact.zones;

  VectorXd& slip = contact.slip;
  if (soft) slip[edge] -= soft->compliance * state.traction[edge];
  const VectorXd mean = (state.traction + before) / 2;
  step.mean_dissipation -= window_.spacing() * mean.dot(slip - conditions.offset);
  slip[edge] -= added;
  state.approach.advance(enters ? 1 : phase_now, enters ? 0 : slip[window_.coming()],
                         slip[enters ? window_.coming() : window_.ahead()]);
  if (enters) {
    state.approach.enter();
    state.sliding_direction = trailing_direction(conditions.bound, state.zones);
  }
  if (at(state.zones, edge) == Zone::adhesion) slip[edge] = 0;

  step.bound = conditions.bound;
  step.slip = moved_on(step.slip, moved, 0.0) + slip;
  step.creepage += contact.creepage;
  step.dissipation -= window_.spacing() * state.traction.dot(slip);
  step.mean_force += mean.sum() * window_.spacing() * length;
  step.iterations += contact.iterations;
}

}  // namespace microslip
