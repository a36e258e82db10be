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

/// Part of the coming node's element that is inside when nothing rolls: where tractions are
/// singular, the scheme feels the leading edge half an element nearer than in rolling.
constexpr double coming_in_shift = 0.5;

bool sticks(const std::vector<Zone>& zones, Index i) {
  return zones[static_cast<std::size_t>(i)] == Zone::adhesion;
}

double direction(Zone zone) { return static_cast<double>(zone); }

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
  before_.swap(ahead_);
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

MaterialRolling::MaterialRolling(const Kernel& kernel, const TractionBound& bound, const Grid& grid,
                                 const Solver& solver)
    : MaterialRolling(kernel, bound, grid, solver, leading_edge_constants(constant_basis())) {}

MaterialRolling::MaterialRolling(const Kernel& kernel, const TractionBound& bound, const Grid& grid,
                                 const Solver& solver, const LeadingEdgeConstants& edge)
    : bound_(bound),
      window_(bound, grid, edge.offset),
      edge_(edge),
      compliance_(edge.compliance * compliance(material_of(kernel)) * window_.spacing()),
      active_set_(
          influence_operator(kernel, constant_basis(), window_.spacing(), window_.size(), solver),
          VectorXd::Constant(window_.size(), window_.spacing()), solver) {}

double MaterialRolling::phase(const MaterialState& state) const {
  return state.distance / window_.spacing() - state.entered;
}

VectorXd MaterialRolling::respond(const VectorXd& traction) const {
  return active_set_.response() * traction;
}

VectorXd MaterialRolling::values(const MaterialState& state) const {
  const double part = std::max(0.0, phase(state));
  const VectorXd at_nodes = bound_at(bound_, window_.x(part));
  VectorXd values = VectorXd::Zero(window_.size());
  for (Index i = 0; i <= window_.coming(); ++i) {
    if (at_nodes[i] <= 0) continue;
    const Zone zone = state.contact.zones[static_cast<std::size_t>(i)];
    values[i] = zone == Zone::adhesion
                    ? state.contact.traction[i] / edge_.value(window_.leading() - i, part)
                    : direction(zone) * at_nodes[i];
  }
  return values;
}

VectorXd MaterialRolling::displacement(const MaterialState& state) const {
  return respond(state.contact.traction);
}

/// Compliance of the spring of a node whose element is inside the contact by some part, in (0, 1].
double MaterialRolling::softness(double inside) const {
  return compliance_ * (1 - inside) / inside;
}

MaterialState MaterialRolling::start(const VectorXd& traction) const {
  const VectorXd bound = window_.bound(0);
  MaterialState state;
  state.contact.traction = traction;
  state.contact.slip = VectorXd::Zero(traction.size());
  for (Index i = 0; i < bound.size(); ++i) {
    const bool slips = std::abs(traction[i]) >= bound[i];
    state.contact.zones.push_back(
        !slips ? Zone::adhesion : (traction[i] > 0 ? Zone::slip_positive : Zone::slip_negative));
  }
  state.leaves_softly = sticks(state.contact.zones, window_.leaving(0).node);
  return state;
}

MaterialRolling::Shifted MaterialRolling::shift(const PrescribedForce& force) {
  MaterialState state = start(VectorXd::Zero(window_.size()));
  SlipConditions conditions{.bound = window_.bound(0),
                            .offset = VectorXd::Zero(window_.size()),
                            .reference = state.contact.traction};
  ContactState contact = active_set_.solve(conditions, force, state.contact.zones);
  const auto leaving = window_.leaving(0);
  state.leaves_softly = sticks(contact.zones, leaving.node);
  if (state.leaves_softly && sticks(contact.zones, window_.leading())) {
    window_.bound(0, coming_in_shift, conditions.bound);
    window_.let_leave(0, conditions.bound);
    conditions.soft = {{window_.coming(), softness(coming_in_shift)},
                       {leaving.node, softness(leaving.inside)}};
    contact = active_set_.solve(conditions, force, state.contact.zones);
  }
  state.contact.traction = contact.traction;
  state.contact.zones = contact.zones;
  return {std::move(state), contact.creepage};
}

void MaterialRolling::step(const MaterialState& from, double length, const Load& load,
                           MaterialStep& step) {
  step.end = from;
  step.end.contact.slip.setZero();
  step.end.contact.creepage = 0;
  step.end.contact.iterations = 0;
  step.end.contact.residuals = {};
  step.dissipation = 0;
  step.end_dissipation = 0;
  step.mean_force = 0;
  step.backward = 0;
  // Compensated, or steps of whole elements would be split after some ten thousand.
  const double added = length - from.distance_error;
  const double end = from.distance + added;
  const double error = (end - from.distance) - added;
  double rest = length;
  for (double next = from.entered + 1; end / window_.spacing() - next > MaterialWindow::rounding;
       ++next) {
    const double part = next * window_.spacing() - step.end.distance;
    roll_part(step, part, next * window_.spacing(), load);
    rest -= part;
  }
  roll_part(step, rest, end, load);
  step.end.distance_error = error;
  step.mean_force /= length;
}

/// Those of before at the same places of the contact, to the nearest node; a node that comes or
/// enters is taken to stick.
void MaterialRolling::set_first_zones(const MaterialState& from, const Part& part) {
  contact_.zones = from.contact.zones;
  move_on(contact_.zones, part.before > 0.5 ? part.moved : 0, Zone::slip_negative);
  const bool was_out = part.before <= MaterialWindow::rounding;
  if (was_out && part.edge_is_new) at(contact_.zones, part.edge) = Zone::adhesion;
}

/// A soft element yields for the change of its traction, and for its former traction as it becomes
/// softer. The condition of one that enters or comes is about the last element travelled.
void MaterialRolling::set_conditions(MaterialState& state, const Part& part) {
  window_.bound(part.now, part.now, conditions_.bound);
  conditions_.offset.setZero(window_.size());
  conditions_.reference = state.contact.traction;
  move_on(conditions_.reference, part.moved, 0.0);
  conditions_.soft.clear();
  if (part.now > MaterialWindow::rounding) {
    conditions_.soft.push_back({window_.coming(), softness(part.now)});
  }
  const auto [leaving, inside] = window_.leaving(part.now);
  const Index before = leaving + part.moved;
  if (before != window_.leaving(part.before).node) {
    state.leaves_softly = sticks(state.contact.zones, before);
  }
  if (state.leaves_softly && inside < 1 - MaterialWindow::rounding) {
    window_.let_leave(part.now, conditions_.bound);
    const double inside_before = window_.inside(before, part.before);
    const double softer = compliance_ * (inside_before - inside) / (inside_before * inside);
    conditions_.soft.push_back({leaving, softness(inside)});
    conditions_.offset[leaving] = softer * conditions_.reference[leaving];
  }
  if (part.edge_is_new) {
    const double part_inside = part.moved == 1 ? 1 : part.now;
    conditions_.offset[part.edge] = softness(part_inside) * conditions_.reference[part.edge] +
                                    state.approach.since_one_element_before(part_inside);
  }
}

/// Up to the next node's entrance at most.
void MaterialRolling::roll_part(MaterialStep& step, double length, double end, const Load& load) {
  MaterialState& state = step.end;
  const bool enters = end / window_.spacing() - state.entered >= 1 - MaterialWindow::rounding;
  const double now = end / window_.spacing() - state.entered - (enters ? 1 : 0);
  const Part part{.before = phase(state),
                  .now = now,
                  .length = length,
                  .moved = enters ? 1 : 0,
                  .edge = enters ? window_.leading() : window_.coming(),
                  .edge_is_new = enters || now > MaterialWindow::rounding};
  set_conditions(state, part);
  set_first_zones(state, part);
  active_set_.solve(conditions_, over(load, length), contact_);

  const VectorXd& traction = contact_.traction;
  VectorXd& slip = contact_.slip;
  for (const auto& [element, compliance] : conditions_.soft) {
    slip[element] -= compliance * (traction[element] - conditions_.reference[element]);
  }
  slip -= conditions_.offset;
  const auto mean = (traction + conditions_.reference) / 2;
  step.dissipation -= window_.spacing() * mean.dot(slip);
  step.mean_force += mean.sum() * window_.spacing() * length;

  state.distance = end;
  if (enters) {
    state.approach.advance(1, 0, slip[window_.coming()]);
    state.approach.enter();
    state.entered += 1;
  } else {
    state.approach.advance(part.now, slip[window_.coming()], slip[window_.ahead()]);
  }
  step.end_dissipation -= window_.spacing() * traction.dot(slip);
  const auto yields = [&](Index element) {
    if (at(contact_.zones, element) == Zone::adhesion) slip[element] = 0;
  };
  yields(part.edge);
  for (const auto& soft : conditions_.soft) yields(soft.element);

  step.bound = conditions_.bound;
  step.backward += window_.spacing() * traction.cwiseProduct(slip).cwiseMax(0).sum();
  state.contact.traction = traction;
  state.contact.zones = contact_.zones;
  move_on(state.contact.slip, part.moved, 0.0);
  state.contact.slip += slip;
  state.contact.creepage += contact_.creepage;
  state.contact.iterations += contact_.iterations;
  double& residual = state.contact.residuals.equations;
  residual = std::max(residual, contact_.residuals.equations);
}

}  // namespace microslip
