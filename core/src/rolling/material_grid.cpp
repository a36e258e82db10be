// SPDX-License-Identifier: GPL-3.0-or-later
#include "material_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Points of the history that are closer together would only cost memory  [dx]
constexpr double history_resolution = 1e-3;

Zone& at(std::vector<Zone>& zones, Index i) { return zones[static_cast<std::size_t>(i)]; }

/// Fraction of an element by which the nodes to come are farther inside when nothing rolls: where
/// tractions are singular, the scheme feels the leading edge half an element nearer.
constexpr double nearer_in_shift = 0.5;

/// The part of the element of the node ahead that is inside when nothing rolls.
double ahead_in_shift(double phase) {
  const double inside = phase - (1 - nearer_in_shift);
  return inside > MaterialWindow::rounding ? inside : 0;
}

double direction(Zone zone) { return static_cast<double>(zone); }

}  // namespace

void IncomingNode::advance(double phase, double coming_slip, double ahead_slip) {
  coming_ += coming_slip;
  const double ahead = (ahead_.empty() ? 0 : ahead_.back().slip) + ahead_slip;
  const double last_but_one = ahead_.size() < 2 ? 0 : ahead_[ahead_.size() - 2].phase;
  const bool close = !ahead_.empty() && phase - last_but_one < history_resolution;
  if (close) ahead_.pop_back();
  ahead_.push_back({phase, ahead});
}

void IncomingNode::enter() {
  before_.swap(ahead_);
  ahead_.clear();
  coming_ = before_.empty() ? 0 : before_.back().slip;
}

double IncomingNode::since_one_element_before(double phase) const {
  Point from{0, 0};
  for (const Point& to : before_) {
    if (phase < to.phase) {
      const double fraction = (phase - from.phase) / (to.phase - from.phase);
      return coming_ - ((1 - fraction) * from.slip + fraction * to.slip);
    }
    from = to;
  }
  return coming_ - from.slip;
}

MaterialGrid::MaterialGrid(const TransientProblem& problem)
    : MaterialGrid(problem, leading_edge_constants(constant_basis())) {}

MaterialGrid::MaterialGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge)
    : MaterialGrid(problem, edge, MaterialWindow(problem.bound, problem.grid, edge.offset)) {}

MaterialGrid::MaterialGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
                           const MaterialWindow& window)
    : RollingGrid(influence_operator(problem.kernel, constant_basis(), window.spacing(),
                                     window.size(), problem.solver),
                  VectorXd::Constant(window.size(), window.spacing()), problem.solver),
      traction_bound_(problem.bound),
      problem_nodes_(problem.grid.nodes()),
      window_(window),
      edge_(edge),
      compliance_(edge.compliance * compliance(material_of(problem.kernel)) * window.spacing()) {}

std::unique_ptr<RollingGrid> MaterialGrid::clone() const {
  return std::make_unique<MaterialGrid>(*this);
}

VectorXd MaterialGrid::traction_at_nodes(const TransientState& state) const {
  const double fraction = std::max(0.0, state_.phase(window_.spacing()));
  const VectorXd at_nodes = bound_at(traction_bound_, window_.x(fraction));
  VectorXd values = VectorXd::Zero(window_.size());
  for (Index i = 0; i <= window_.coming(); ++i) {
    if (at_nodes[i] <= 0) continue;
    const Zone zone = state.zones[static_cast<std::size_t>(i)];
    values[i] = zone == Zone::adhesion
                    ? state.traction[i] / edge_.value(window_.leading() - i, fraction)
                    : direction(zone) * at_nodes[i];
  }
  return values;
}

/// Compliance of the spring of a node, of whose element the fraction `inside` is in the contact, in
/// (0, 1].
double MaterialGrid::spring_compliance(double inside) const {
  return compliance_ * (1 - inside) / inside;
}

/// \param traction  at the nodes of the window, within its bound
MaterialState MaterialGrid::at_rest(const VectorXd& traction) const {
  MaterialState state;
  state.contact.traction = traction;
  state.contact.slip = VectorXd::Zero(traction.size());
  state.contact.zones = zones_at(traction, window_.bound(0));
  state.leaves_by_spring = sticks(state.contact.zones, window_.leaving(0).node);
  return state;
}

void MaterialGrid::begin(MaterialState start, TransientState& state) {
  state_ = std::move(start);
  x_ = window_.x(0);
  bound_ = window_.bound(0);
  fill_state(0, state_.contact, 1, bound_, bound_, state);
}

/// Takes the ratio of tractions to the bound to the nodes of the window.
void MaterialGrid::start_from(const VectorXd& traction, TransientState& state) {
  const VectorXd ratio = ratio_to_bound(traction_bound_, problem_nodes_, traction);
  const VectorXd at_nodes = interpolated(problem_nodes_, ratio, window_.x(0));
  begin(at_rest(window_.bound(0).cwiseProduct(at_nodes)), state);
}

/// Bounds and springs of a shift. Next to the trailing edge, and next to a leading edge that is
/// held, bounds are no smaller than the tractions that are there, so that a shift of nothing
/// changes nothing.
void MaterialGrid::set_shift_conditions(double phase, const HeldEdges& held) {
  const double ahead = held.leading ? ahead_in_shift(phase) : 0;
  const double coming = held.leading ? std::max(phase, nearer_in_shift) : phase;
  window_.bound(phase, coming, conditions_.bound, ahead);
  conditions_.offset.setZero(window_.size());
  conditions_.compliant.clear();
  const auto hold = [&](Index node, double inside) {
    conditions_.compliant.push_back({node, spring_compliance(inside)});
  };
  const auto keep = [&](Index first, Index count) {
    auto bounds = conditions_.bound.segment(first, count);
    bounds = bounds.cwiseMax(conditions_.reference.segment(first, count).cwiseAbs());
  };
  if (held.leading) {
    hold(window_.coming(), std::min(1.0, phase + nearer_in_shift));
    if (ahead > 0) hold(window_.ahead(), ahead);
    keep(window_.leading(), 3);
  }
  const auto leaving = window_.leaving(phase);
  if (held.trailing) {
    window_.let_leave(phase, conditions_.bound);
    hold(leaving.node, leaving.inside);
  }
  keep(leaving.node, 2);
}

/// Holds the edges by springs if both stick without.
Shift MaterialGrid::solve_shift(const TransientState&, const Load& load, TransientState& after) {
  step_.end = state_;
  MaterialState& state = step_.end;
  const double now = std::max(0.0, state.phase(window_.spacing()));
  const Index leaving = window_.leaving(now).node;
  const bool slides_out = state.leaves_by_spring && !sticks(state.contact.zones, leaving);
  conditions_.reference = state.contact.traction;
  const auto solve = [&](const HeldEdges& held) {
    set_shift_conditions(now, held);
    contact_.zones = state.contact.zones;
    active_set_.solve(conditions_, load, contact_);
  };
  solve({.leading = false, .trailing = slides_out});
  // An element that is beyond the edge tells nothing.
  const bool in_contact = window_.bound(now)[leaving] > 0;
  const bool trailing_sticks = sticks(contact_.zones, in_contact ? leaving : leaving + 1);
  const bool both_stick = trailing_sticks && sticks(contact_.zones, window_.leading());
  if (both_stick) solve({.leading = true, .trailing = true});
  state.leaves_by_spring = slides_out || trailing_sticks;
  state.ahead_share = both_stick ? ahead_in_shift(now) : 0;

  VectorXd slip = contact_.slip;
  for (const auto& [element, compliance] : conditions_.compliant) {
    slip[element] -= compliance * (contact_.traction[element] - conditions_.reference[element]);
  }
  state.contact = contact_;
  step_.bound = conditions_.bound;
  return fill_shift(state.distance, conditions_.reference, contact_, slip, step_.bound, step_.bound,
                    after);
}

void MaterialGrid::solve_step(const TransientState&, double length, const Load& load,
                              TransientState& after, StepJacobian* jacobian) {
  require_no_jacobian(jacobian);
  roll(length, load);
  fill_state(step_.end.distance, step_.end.contact, length, step_.bound, step_.bound, after);
  after.dissipation = step_.dissipation / length;
  after.end_dissipation = step_.end_dissipation / length;
  after.mean_force = step_.mean_force;
  after.evidence.backward = step_.backward / length;
}

void MaterialGrid::accept_step() {
  std::swap(state_, step_.end);
  bound_.swap(step_.bound);
  x_ = window_.x(state_.phase(window_.spacing()));
}

void MaterialGrid::move_to(double distance) { state_.move_to(distance); }

void MaterialGrid::roll(double length, const Load& load) {
  step_.end = state_;
  step_.end.contact.slip.setZero();
  step_.end.contact.creepage = 0;
  step_.end.contact.iterations = 0;
  step_.end.contact.residuals = {};
  step_.dissipation = 0;
  step_.end_dissipation = 0;
  step_.mean_force = 0;
  step_.backward = 0;
  step_.end.distance_error =
      for_each_part(state_, length, window_.spacing(),
                    [&](double part, double end, double) { roll_substep(part, end, load); });
  step_.mean_force /= length;
}

/// Takes the zones before at the same places of the contact, to the nearest node. A node that comes
/// or enters is taken to stick.
void MaterialGrid::set_first_zones(const MaterialState& from, const Substep& substep) {
  contact_.zones = from.contact.zones;
  move_on(contact_.zones, substep.before > 0.5 ? substep.moved : 0, Zone::slip_negative);
  const bool was_out = substep.before <= MaterialWindow::rounding;
  if (was_out && substep.edge_is_new) at(contact_.zones, substep.edge) = Zone::adhesion;
}

/// A spring yields to the change of its traction, and to its former traction as its compliance
/// grows. The condition of a node that enters or comes is about the last element travelled.
void MaterialGrid::set_conditions(MaterialState& state, const Substep& substep) {
  const bool enters = substep.moved == 1;
  if (enters) {
    window_.bound(0, state.ahead_share, conditions_.bound);
  } else {
    window_.bound(substep.now, substep.now, conditions_.bound, state.ahead_share);
  }
  conditions_.offset.setZero(window_.size());
  conditions_.reference = state.contact.traction;
  move_on(conditions_.reference, substep.moved, 0.0);
  conditions_.compliant.clear();
  if (substep.now > MaterialWindow::rounding) {
    conditions_.compliant.push_back({window_.coming(), spring_compliance(substep.now)});
  }
  if (state.ahead_share > 0) {
    conditions_.compliant.push_back(
        {enters ? window_.coming() : window_.ahead(), spring_compliance(state.ahead_share)});
  }
  const auto [leaving, inside] = window_.leaving(substep.now);
  const Index before = leaving + substep.moved;
  if (before != window_.leaving(substep.before).node) {
    state.leaves_by_spring = sticks(state.contact.zones, before);
  }
  if (state.leaves_by_spring && inside < 1 - MaterialWindow::rounding) {
    window_.let_leave(substep.now, conditions_.bound);
    const double inside_before = window_.inside(before, substep.before);
    const double grown = compliance_ * (inside_before - inside) / (inside_before * inside);
    conditions_.compliant.push_back({leaving, spring_compliance(inside)});
    conditions_.offset[leaving] = grown * conditions_.reference[leaving];
  }
  if (substep.edge_is_new) {
    const double inside_now = substep.moved == 1 ? 1 : substep.now;
    conditions_.offset[substep.edge] =
        spring_compliance(inside_now) * conditions_.reference[substep.edge] +
        state.incoming.since_one_element_before(inside_now);
  }
}

/// Rolls up to the next node's entrance at most.
void MaterialGrid::roll_substep(double length, double end, const Load& load) {
  MaterialState& state = step_.end;
  const bool enters = end / window_.spacing() - state.entered >= 1 - MaterialWindow::rounding;
  const double now = end / window_.spacing() - state.entered - (enters ? 1 : 0);
  const Substep substep{.before = state.phase(window_.spacing()),
                        .now = now,
                        .moved = enters ? 1 : 0,
                        .edge = enters ? window_.leading() : window_.coming(),
                        .edge_is_new = enters || now > MaterialWindow::rounding};
  set_conditions(state, substep);
  set_first_zones(state, substep);
  active_set_.solve(conditions_, load_of_step(load, length), contact_);

  const VectorXd& traction = contact_.traction;
  VectorXd& slip = contact_.slip;
  for (const auto& [element, compliance] : conditions_.compliant) {
    slip[element] -= compliance * (traction[element] - conditions_.reference[element]);
  }
  slip -= conditions_.offset;
  const auto mean = (traction + conditions_.reference) / 2;
  step_.dissipation -= window_.spacing() * mean.dot(slip);
  step_.mean_force += mean.sum() * window_.spacing() * length;

  state.distance = end;
  if (enters) {
    state.incoming.advance(1, 0, slip[window_.coming()]);
    state.incoming.enter();
    state.entered += 1;
    state.ahead_share = 0;
  } else {
    state.incoming.advance(substep.now, slip[window_.coming()], slip[window_.ahead()]);
  }
  step_.end_dissipation -= window_.spacing() * traction.dot(slip);
  const auto yields = [&](Index element) {
    if (at(contact_.zones, element) == Zone::adhesion) slip[element] = 0;
  };
  yields(substep.edge);
  for (const auto& spring : conditions_.compliant) yields(spring.element);

  step_.bound = conditions_.bound;
  step_.backward += window_.spacing() * traction.cwiseProduct(slip).cwiseMax(0).sum();
  state.contact.traction = traction;
  state.contact.zones = contact_.zones;
  move_on(state.contact.slip, substep.moved, 0.0);
  state.contact.slip += slip;
  state.contact.creepage += contact_.creepage;
  state.contact.iterations += contact_.iterations;
  double& residual = state.contact.residuals.equations;
  residual = std::max(residual, contact_.residuals.equations);
}

}  // namespace microslip
