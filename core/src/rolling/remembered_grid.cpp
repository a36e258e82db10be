// SPDX-License-Identifier: GPL-3.0-or-later
#include "remembered_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "microslip/halfspace/influence.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The interpolation between points is cubic.
constexpr Index fewest_nodes = 4;

/// Points that have slipped so many elements ago, or fewer, are kept as if they had not: the
/// partitions whose mean is taken include their nodes in adhesion.
constexpr Index kept_behind = 3;

/// Without rolling, tractions in adhesion are singular at the leading edge, which the scheme then
/// feels half an element nearer. So an element at the entry carries traction, on a spring that is
/// the mean of the solutions with and without it.
constexpr double entry_in_shift = 0.5;

/// The value at index i + shift of values at whole indices, cubic.
/// \param shift  in [0, 1]
/// \param from   the values used have this index at least
double interpolated_at(const VectorXd& values, Index i, double shift, Index from) {
  if (shift <= 0) return values[i];
  if (shift >= 1) return values[i + 1];
  const Index last = values.size() - fewest_nodes;
  const Index a = std::clamp(i - 1, std::min(from, last), last);
  const double z = static_cast<double>(i - a) + shift;
  const auto factor = [z](Index k) { return z - static_cast<double>(k); };
  return -factor(1) * factor(2) * factor(3) / 6 * values[a] +
         factor(0) * factor(2) * factor(3) / 2 * values[a + 1] -
         factor(0) * factor(1) * factor(3) / 2 * values[a + 2] +
         factor(0) * factor(1) * factor(2) / 6 * values[a + 3];
}

/// The load after a fraction of a step: a force changes linearly over it.
/// \param before  the force at its beginning  [N/mm]
Load load_within(const Load& load, double before, double fraction) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return load;
  return PrescribedForce{std::lerp(before, force->value, fraction)};
}

}  // namespace

RememberedGrid::RememberedGrid(const TransientProblem& problem)
    : RememberedGrid(problem, leading_edge_constants(constant_basis())) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge)
    : RememberedGrid(problem, edge,
                     Grid({.half_width = problem.grid.half_width(),
                           .elements = problem.grid.size(),
                           .leading_offset = edge.offset,
                           .trailing_offset = edge.offset - 0.5})) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
                               const Grid& grid)
    : RollingGrid(influence_operator(problem.kernel, constant_basis(), grid.spacing(), grid.size(),
                                     problem.solver),
                  VectorXd::Constant(grid.size(), grid.spacing()), problem.solver),
      traction_bound_(problem.bound),
      problem_nodes_(problem.grid.nodes()),
      spacing_(grid.spacing()),
      edge_(edge),
      kernel_(problem.kernel),
      solver_(problem.solver),
      stick_slip_point_(edge) {
  require_filling(problem.grid, fewest_nodes, "where the material remembers its displacement");
  const Index n = grid.size();
  x_ = grid.nodes();
  bound_ = element_means(problem.bound, x_, weights_);
  entry_influence_.resize(n);
  for (Index j = 0; j < n; ++j) {
    entry_influence_[j] =
        influence(kernel_, constant_shape(), spacing_, static_cast<double>(n - j));
  }
  conditions_.bound = bound_;
  conditions_.reference = VectorXd::Zero(n);
}

std::unique_ptr<RollingGrid> RememberedGrid::clone() const {
  return std::make_unique<RememberedGrid>(*this);
}

VectorXd RememberedGrid::traction_at_nodes(const TransientState& state) const {
  const VectorXd at_nodes = bound_at(traction_bound_, x_);
  VectorXd values(x_.size());
  for (Index i = 0; i < x_.size(); ++i) {
    const Zone zone = state.zones[static_cast<std::size_t>(i)];
    values[i] = zone == Zone::adhesion
                    ? std::clamp(state.traction[i] / edge_.value(x_.size() - 1 - i, 0),
                                 -at_nodes[i], at_nodes[i])
                    : static_cast<double>(zone) * at_nodes[i];
  }
  return values;
}

double RememberedGrid::displacement_at_entry(const VectorXd& traction) const {
  return entry_influence_.dot(traction);
}

/// From tractions that nothing has rolled with.
void RememberedGrid::begin(const VectorXd& traction, TransientState& state) {
  state_ = {};
  state_.traction = traction;
  state_.zones = zones_at(traction, bound_);
  state_.nodes.resize(x_.size() + 1);
  state_.nodes << displacement(traction), displacement_at_entry(traction);
  state_.stored = spacing_ * traction.dot(state_.nodes.head(x_.size())) / 2;
  remember_all(state_);
  fill_state(0, {.traction = traction, .slip = VectorXd::Zero(x_.size()), .zones = state_.zones}, 1,
             bound_, bound_, state);
}

void RememberedGrid::remember_all(RememberedState& state) const {
  state.points = state.nodes;
  state.stuck = first_stuck(state.zones);
  state.kept = state.stuck;
}

/// Takes the ratio of tractions to the bound to the nodes of this grid.
void RememberedGrid::start_from(const VectorXd& traction, TransientState& state) {
  const VectorXd ratio = ratio_to_bound(traction_bound_, problem_nodes_, traction);
  begin(bound_.cwiseProduct(interpolated(problem_nodes_, ratio, x_)), state);
}

double RememberedGrid::start_from_shift(const PrescribedForce& force, TransientState& state) {
  const Index n = x_.size();
  const double distance = RollingGrid::start_from_shift(force, state);
  if (!sticks(state.zones, n - 1)) {
    remember_all(state_);
    return distance;
  }

  VectorXd bound(n + 1);
  bound << bound_, bound_[n - 1];
  const double spring = edge_.compliance * compliance(material_of(kernel_)) * spacing_ *
                        (1 - entry_in_shift) / entry_in_shift;
  ActiveSet with_entry(influence_operator(kernel_, constant_basis(), spacing_, n + 1, solver_),
                       VectorXd::Constant(n + 1, spacing_), solver_);
  const VectorXd zeros = VectorXd::Zero(n + 1);
  const ContactState longer = with_entry.solve(
      {.bound = bound, .offset = zeros, .reference = zeros, .compliant = {{n, spring}}}, force);
  VectorXd traction = longer.traction.head(n);
  traction[n - 1] += longer.traction[n];
  begin(traction, state);
  state_.zones.assign(longer.zones.begin(), longer.zones.end() - 1);
  state_.nodes = with_entry.response() * longer.traction;
  remember_all(state_);
  state.zones = state_.zones;
  return longer.creepage;
}

/// A part of a step that travels nothing.
Shift RememberedGrid::solve_shift(const TransientState& before, const Load& load,
                                  TransientState& after) {
  begin_sum();
  roll_part(0, state_.distance, load);
  // The point that came to the entry last sticks if it is in the contact and its neighbours do.
  const Index n = x_.size();
  const double now = std::max(0.0, state_.phase(spacing_));
  if (now < 1 - edge_.offset || !sticks(next_.zones, n - 1)) {
    next_.points[n] = now * next_.nodes[n - 1] + (1 - now) * next_.nodes[n];
  }
  const auto* distance = std::get_if<PrescribedCreepage>(&load);
  if (distance != nullptr) sum_.creepage = distance->value;
  sum_.zones = next_.zones;
  sum_.traction = next_.traction;
  const VectorXd slip = displacement(next_.traction - before.traction).array() + sum_.creepage;
  return fill_shift(before.distance, before.traction, sum_, slip, bound_, bound_, after);
}

void RememberedGrid::begin_sum() {
  next_ = state_;
  sum_.slip.setZero(x_.size());
  sum_.creepage = 0;
  sum_.iterations = 0;
  sum_.residuals = {};
  mean_force_ = 0;
  work_ = 0;
}

void RememberedGrid::solve_step(const TransientState&, double length, const Load& load,
                                TransientState& after) {
  begin_sum();
  const double force = spacing_ * state_.traction.sum();
  next_.distance_error =
      for_each_part(state_, length, spacing_, [&](double part, double end, double rest) {
        const Load within = load_within(load, force, 1 - rest / length);
        roll_part(part, end, load_of_step(within, part));
      });

  sum_.zones = next_.zones;
  fill_state(next_.distance, sum_, length, bound_, bound_, after);
  after.traction = next_.traction;
  after.force = weights_.dot(next_.traction);
  after.mean_force = mean_force_ / length;
  after.dissipation = -(work_ + next_.stored - state_.stored) / length;
}

void RememberedGrid::accept_step() { std::swap(state_, next_); }

void RememberedGrid::move_to(double distance) { state_.move_to(distance); }

/// Sets the displacements with which the material has come to the nodes.
/// \param phase      at the end of the part
/// \param travelled  since the part began  [dx]
void RememberedGrid::recall(const RememberedState& state, double phase, double travelled) {
  conditions_.offset.resize(x_.size());
  for (Index i = 0; i < x_.size(); ++i) {
    const bool as_if_stuck = i >= state.kept && i < state.stuck;
    const bool from_nodes = !sticks(state.zones, i) && !as_if_stuck;
    const Index from = i >= state.kept ? state.kept : 0;
    conditions_.offset[i] = from_nodes ? -interpolated_at(state.nodes, i, travelled, 0)
                                       : -interpolated_at(state.points, i, phase, from);
  }
}

/// Points next to the stick-slip point have slipped as they did: they stick again.
void RememberedGrid::admit_slip(RememberedState& state) const {
  const double now = std::max(0.0, state.phase(spacing_));
  for (Index i = state.kept; i < std::min(state.stuck, x_.size()); ++i) {
    state.points[i] =
        i == 0 ? state.nodes[0] : now * state.nodes[i - 1] + (1 - now) * state.nodes[i];
  }
  state.kept = state.stuck;
}

/// Remembers the displacements at the end of the part.
void RememberedGrid::remember(RememberedState& state, double phase, bool stuck_again) const {
  const Index n = x_.size();
  state.stuck = first_stuck(state.zones);
  state.kept = stuck_again ? state.stuck : std::max<Index>(0, state.stuck - kept_behind);
  const auto has_slipped = [&](Index i) {
    return i < n && !sticks(state.zones, i) && (i < state.kept || i > state.stuck);
  };
  if (phase >= 1) {
    std::shift_left(state.points.begin(), state.points.end(), 1);
    state.points[n] = state.nodes[n];
    for (Index i = 0; i < n; ++i) {
      if (has_slipped(i)) state.points[i] = state.nodes[i];
    }
    return;
  }
  if (phase == 0 && has_slipped(0)) state.points[0] = state.nodes[0];
  for (Index i = 1; i < n; ++i) {
    if (!has_slipped(i) || (phase > 0 && sticks(state.zones, i - 1))) continue;
    state.points[i] = phase * state.nodes[i - 1] + (1 - phase) * state.nodes[i];
  }
}

/// Adds the slip of a part. Next to the stick-slip point, slip is counted since a point was in
/// adhesion, so that what it had slipped before has to be taken away.
void RememberedGrid::add_slip(const RememberedState& before, double travelled) {
  sum_.slip += contact_.slip;
  for (Index i = before.kept; i < std::min(before.stuck, x_.size()); ++i) {
    if (sticks(contact_.zones, i)) continue;
    sum_.slip[i] -= interpolated_at(before.nodes, i, travelled, 0) + conditions_.offset[i];
  }
}

/// Rolls up to where an element has been travelled at most.
/// \param load  its creepage is the shift  [mm]
void RememberedGrid::roll_part(double length, double end, const Load& load) {
  RememberedState& state = next_;
  const double now = end / spacing_ - state.entered;
  const bool whole = now >= 1 - MaterialWindow::rounding;
  const double phase_now = whole ? 1 : now;
  const double travelled = std::min(1.0, phase_now - std::max(0.0, state.phase(spacing_)));

  Load shift = load;
  if (auto* creepage = std::get_if<PrescribedCreepage>(&shift)) creepage->value += state.lead;
  recall(state, phase_now, travelled);
  contact_.zones = state.zones;
  active_set_.solve(conditions_, shift, contact_);
  sum_.iterations += contact_.iterations;
  const bool stuck_again = first_stuck(contact_.zones) < state.stuck - 1;
  if (stuck_again) {
    admit_slip(state);
    recall(state, phase_now, travelled);
    contact_.zones = state.zones;
    active_set_.solve(conditions_, shift, contact_);
    sum_.iterations += contact_.iterations;
  }
  double& residual = sum_.residuals.equations;
  residual = std::max(residual, contact_.residuals.equations);

  const double force_before = spacing_ * state.traction.sum();
  const double moved = contact_.creepage;
  add_slip(state, travelled);
  sum_.traction = contact_.traction;
  state.points.array() -= moved;
  displacement_ = (contact_.slip - conditions_.offset).array() - moved;
  state.nodes.head(x_.size()) = displacement_;
  stick_slip_point_.average(active_set_, conditions_, shift, contact_, displacement_);
  state.stored = spacing_ * contact_.traction.dot(displacement_) / 2;
  const double creepage = contact_.creepage - state.lead;
  state.lead = contact_.creepage - moved;
  state.nodes[x_.size()] = displacement_at_entry(contact_.traction) + state.lead;
  state.traction = contact_.traction;
  state.zones = contact_.zones;
  remember(state, phase_now, stuck_again);
  state.distance = end;
  if (whole) state.entered += 1;

  const double mean_force = (force_before + spacing_ * state.traction.sum()) / 2;
  sum_.creepage += creepage;
  mean_force_ += mean_force * length;
  work_ += mean_force * creepage;
}

}  // namespace microslip
