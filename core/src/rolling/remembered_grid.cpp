// SPDX-License-Identifier: GPL-3.0-or-later
#include "remembered_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/edge_calibration.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Returns the displacement by an element against the distance in elements, from the entry to the
/// exit, for a kernel on the problem's contact  [mm^3/N]
VectorXd influence_at_distances(const Kernel& kernel, const ReferenceNodes& nodes) {
  return VectorXd::NullaryExpr(nodes.size + 2, [&](Index distance) {
    return influence(kernel, constant_shape(), nodes.spacing, static_cast<double>(distance));
  });
}

/// Returns the displacement by the pressure; it is zero in the middle of a symmetric contact.
/// \param x  of the nodes  [mm]
/// \return at nodes, entry and exit  [mm]
VectorXd pressed_at(const TransientProblem& problem, const VectorXd& x, double spacing) {
  const Index n = x.size();
  const auto integral = [&](double place) {
    return std::visit([&](const auto& bound) { return bound.integral(place); },
                      problem.contact.bound);
  };
  VectorXd pressed(n + 2);
  for (Index i = 0; i < n; ++i) pressed[i] = integral(x[i]);
  pressed[n] = std::lerp(pressed[n - 1], integral(x[n - 1] + spacing), pressure_seen_at_edge);
  pressed[n + 1] = integral(x[0] - spacing);
  const double middle = full_sliding_force(problem.contact.bound) / 2;
  return problem.contact.pressure_strain * (pressed.array() - middle);
}

}  // namespace

/// Nodes are 2 a/N apart, so that a step of one element is not divided, and the last node stands
/// where the scheme feels the leading edge at the contact's edge. The first node would then feel
/// the trailing edge 0.15 elements behind the contact's edge.
double RememberedGrid::exit_share(const LeadingEdgeConstants& edge) {
  return 2.5 - 2 * edge.offset;
}

RememberedGrid::RememberedGrid(const TransientProblem& problem)
    : RememberedGrid(problem,
                     leading_edge_constants(constant_basis(), softness(problem.contact.kernel,
                                                                       problem.grid.spacing()))) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge)
    : RememberedGrid(problem, edge,
                     Grid({.half_width = problem.grid.half_width(),
                           .elements = problem.grid.size(),
                           .leading_offset = edge.offset,
                           .trailing_offset = 1 - edge.offset})) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
                               const Grid& grid)
    : RollingGrid(influence_operator(problem.contact.kernel, constant_basis(), grid.spacing(),
                                     grid.size(), problem.solver),
                  VectorXd::Constant(grid.size(), grid.spacing()), problem.solver,
                  problem.contact.pressure_strain),
      traction_bound_(problem.contact.bound),
      problem_nodes_(problem.grid.nodes()),
      edge_(edge),
      kernel_(problem.contact.kernel),
      has_layer_(problem.contact.kernel.layer_compliance() > 0),
      solver_(problem.solver),
      spring_{edge.compliance *
              (std::numbers::pi * problem.contact.kernel.log_factor() * grid.spacing() +
               problem.contact.kernel.layer_compliance())},
      exit_{0, spring_.of_mean(exit_share(edge))},
      stick_slip_point_(edge, exit_share(edge)) {
  require_filling(problem.grid, fewest_points, "where the material remembers its displacement");
  const Index n = grid.size();
  x_ = grid.nodes();
  problem_x_ = x_;
  reach_ = problem.grid.half_width() + problem.grid.spacing();
  nodes_ = {.size = n, .spacing = grid.spacing(), .first = x_[0] / grid.spacing()};
  problem_bound_ = element_means(problem.contact.bound, x_, weights_);
  bound_ = problem_bound_;
  const VectorXd zeros = VectorXd::Zero(n);
  next_.conditions = {.bound = bound_, .offset = zeros, .reference = zeros, .compliant = {exit_}};
  for (Step& slope : slopes_) {
    slope.conditions = next_.conditions;
    slope.conditions.bound = zeros;
  }
  influence_ = influence_at_distances(kernel_, nodes_);
  if (has_unlike_bodies()) pressed_ = pressed_at(problem, x_, grid.spacing());
}

std::unique_ptr<RollingGrid> RememberedGrid::clone() const {
  return std::make_unique<RememberedGrid>(*this);
}

/// Sets the response on a contact of the given half-width (over the problem's) to tractions on the
/// problem's contact: the kernel's lengths are divided by the half-width.
void RememberedGrid::set_response(double half_width) {
  if (kernel_.is_plane()) {
    const double common = -kernel_.log_factor() * std::log(half_width);
    next_.conditions.common = common;
    for (Step& slope : slopes_) slope.conditions.common = common;
  } else if (half_width != response_to_) {
    const Kernel kernel = kernel_.in_units_of(half_width);
    active_set_ = ActiveSet(
        influence_operator(kernel, constant_basis(), nodes_.spacing, nodes_.size, solver_),
        weights_, solver_);
    influence_ = influence_at_distances(kernel, nodes_);
    stick_slip_point_ = StickSlipPoint(edge_, exit_share(edge_));
    standing_.reset();
  }
  response_to_ = half_width;
}

/// Sets the bound of tractions on the problem's contact.
void RememberedGrid::set_bound(const ContactScale& scale) {
  next_.conditions.bound = scale.full_sliding() * problem_bound_;
}

VectorXd RememberedGrid::traction_at_nodes(const TransientState& state) const {
  const VectorXd at_nodes = state.scale.bound * bound_at(traction_bound_, problem_x_);
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

VectorXd RememberedGrid::displacement(const VectorXd& traction) {
  if (!state_.scale.carries()) return VectorXd::Zero(traction.size());
  set_response(state_.scale.half_width);
  return displaced_by(state_.scale.half_width * traction);
}

/// Returns the displacement of the nodes by tractions.
/// \param traction  on the problem's contact
VectorXd RememberedGrid::displaced_by(const VectorXd& traction) const {
  VectorXd displacement = (active_set_.response() * traction).array() +
                          next_.conditions.common * weights_.dot(traction);
  displacement[0] += exit_.compliance * traction[0];
  return displacement;
}

/// Adds the displacement by the pressure at the nodes.
void RememberedGrid::press_nodes(RememberedPoints& nodes) const {
  if (has_unlike_bodies()) nodes.at.head(nodes_.size) += pressed_.head(nodes_.size);
}

/// Adds the displacement by the pressure at entry and exit.
void RememberedGrid::press_ends(RememberedPoints& nodes) const {
  if (!has_unlike_bodies()) return;
  nodes.at[nodes_.size] += pressed_[nodes_.size];
  nodes.exit += pressed_[nodes_.size + 1];
}

/// Returns the work of tractions on the strain by the pressure, per distance rolled  [N/mm]
double RememberedGrid::work_of_pressure(const VectorXd& traction) const {
  return has_unlike_bodies() ? pressure_strain_ * nodes_.spacing * traction.dot(problem_bound_) : 0;
}

/// Returns the displacement of the nodes by the element at the entry.
/// \param entry  traction of that element, on the problem's contact
VectorXd RememberedGrid::displaced_by_entry(double entry) const {
  return entry * (influence_.segment(1, nodes_.size).reverse().array() +
                  nodes_.spacing * next_.conditions.common);
}

/// Computes the displacements at entry and exit.
/// \param entry  traction of the element at the entry
void RememberedGrid::displace_ends(RememberedPoints& nodes, const VectorXd& traction,
                                   double entry) const {
  const auto from_next = influence_.segment(1, nodes_.size);
  const double common = next_.conditions.common * (weights_.dot(traction) + nodes_.spacing * entry);
  nodes.at[nodes_.size] = from_next.reverse().dot(traction) + entry * influence_[0] + common;
  nodes.exit = from_next.dot(traction) + entry * influence_[nodes_.size + 1] + common;
}

void RememberedGrid::set_contact(const ContactScale& scale) {
  require_lasting(scale);
  if (scale.half_width != 1) {
    require_half_space(kernel_, "a contact that changes its half-width");
  }
  require(scale.half_width >= 0, "half_width_factor", scale.half_width, "a number >= 0");
  require(scale.bound >= 0, "bound_factor", scale.bound, "a number >= 0");
  if (scale.carries()) require_definite(kernel_, scale.half_width * reach_);
  target_ = scale;
}

/// Makes a state of tractions on a contact that has not rolled yet; the bound that is set limits
/// them.
RememberedState RememberedGrid::start_of(const VectorXd& traction,
                                         const ContactScale& scale) const {
  RememberedState state;
  state.scale = scale;
  state.counted_by = scale.half_width;
  state.traction = traction;
  state.zones = zones_at(traction, next_.conditions.bound);
  state.nodes.at.resize(nodes_.size + 1);
  state.nodes.at.head(nodes_.size) = displaced_by(traction);
  displace_ends(state.nodes, traction, 0);
  state.stored = nodes_.spacing * traction.dot(state.nodes.at.head(nodes_.size)) / 2;
  press_nodes(state.nodes);
  press_ends(state.nodes);
  state.remember_all();
  return state;
}

/// Begins with tractions.
/// \param traction  on the problem's contact, within the bound that is set
void RememberedGrid::begin(const VectorXd& traction, TransientState& state) {
  if (target_.carries()) set_response(target_.half_width);
  state_ = start_of(traction, target_);
  sum_ = {.traction = traction, .slip = VectorXd::Zero(nodes_.size), .zones = state_.zones};
  fill_state(0, sum_, 1, next_.conditions.bound, next_.conditions.bound, state);
  give_tractions(state_, state);
  place_nodes();
}

/// Writes the tractions on the present contact into a state: the mean over partitions.
void RememberedGrid::give_tractions(const RememberedState& now, TransientState& state) const {
  state.scale = now.scale;
  state.force = weights_.dot(now.traction);
  state.traction = now.traction;
  if (now.scale.half_width > 0) state.traction /= now.scale.half_width;
}

/// Places nodes and bound where they are after a step.
void RememberedGrid::place_nodes() {
  if (placed_ == state_.scale) return;
  placed_ = state_.scale;
  x_ = placed_.half_width * problem_x_;
  bound_ = placed_.bound * problem_bound_;
}

/// Begins with tractions of another grid: the nodes keep the ratio of tractions to the bound.
void RememberedGrid::start_from(const VectorXd& traction, TransientState& state) {
  const VectorXd ratio = ratio_to_bound(traction_bound_, problem_nodes_, traction);
  set_bound(target_);
  begin(next_.conditions.bound.cwiseProduct(interpolated(problem_nodes_, ratio, problem_x_)),
        state);
}

void RememberedGrid::begin_step(bool with_slopes) {
  next_.shift = next_.mean_force = next_.work = 0;
  next_.state = state_;
  next_.entry = 0;
  sum_.slip.setZero(x_.size());
  sum_.iterations = 0;
  sum_.residuals = {};
  has_slopes_ = with_slopes;
  if (!with_slopes) return;
  for (Step& slope : slopes_) {
    slope.shift = slope.mean_force = slope.work = 0;
    slope.state = state_;
    slope.state.points.set_zero();
    slope.state.nodes.set_zero();
    slope.state.traction.setZero();
    slope.state.stored = 0;
    slope.state.entry = slope.entry = 0;
    slope.state.shifts.reset();
    slope.state.relief.resize(0);
    slope.conditions.bound.setZero(nodes_.size);
    slope.state.lead = 0;
  }
}

}  // namespace microslip
