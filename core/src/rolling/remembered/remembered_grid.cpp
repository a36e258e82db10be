// SPDX-License-Identifier: GPL-3.0-or-later
#include "remembered_grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

RememberedGrid::RememberedGrid(const TransientProblem& problem)
    : RememberedGrid(problem, RollingRow(problem)) {}

RememberedGrid::RememberedGrid(const TransientProblem& problem, const RollingRow& row)
    : RollingGrid(VectorXd::Constant(row.grid().size(), row.grid().spacing()),
                  problem.contact.pressure_strain),
      traction_bound_(problem.contact.bound),
      problem_nodes_(problem.grid.nodes()),
      problem_x_(row.grid().nodes()),
      reach_(problem.grid.half_width() + problem.grid.spacing()),
      row_(row),
      memory_(row.response().nodes()),
      start_(memory_),
      placed_backward_(false) {
  require_filling(problem.grid, fewest_points, "where the material remembers its displacement");
  x_ = problem_x_;
  bound_ = row.response().bound();
}

namespace {

/// Values of the mirrored row in the contact's frame, or the other way round.
/// The difference from 0 is 0 of a zero, and not -0.
VectorXd mirrored(const VectorXd& values) { return 0 - values.reverse().array(); }

ShiftLoad mirrored(const ShiftLoad& load) {
  if (const auto* force = std::get_if<PrescribedForce>(&load)) {
    return PrescribedForce{0 - force->value};
  }
  return PrescribedShift{0 - std::get<PrescribedShift>(load).value};
}

/// A creepage is a shift over a distance rolled, both of which change their signs.
Load mirrored(const Load& load) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  return force != nullptr ? PrescribedForce{0 - force->value} : load;
}

/// Slip is a displacement over a distance rolled, like creepage.
void mirror(TransientState& state) {
  for (double* one : {&state.distance, &state.force, &state.mean_force}) *one = 0 - *one;
  state.traction = mirrored(state.traction);
  std::ranges::reverse(state.slip);
  std::ranges::reverse(state.zones);
  for (Zone& zone : state.zones) zone = mirrored(zone);
}

void mirror(Shift& shift) {
  shift.distance = 0 - shift.distance;
  shift.slip = mirrored(shift.slip);
}

/// Mirrors derivatives by an input.
/// \param turns  whether the input changes its sign
void mirror(StepSlopes& slopes, bool turns) {
  for (double* one : {&slopes.force, &slopes.mean_force}) *one = turns ? *one : -*one;
  for (double* one : {&slopes.creepage, &slopes.dissipation}) *one = turns ? -*one : *one;
}

}  // namespace

std::unique_ptr<RollingGrid> RememberedGrid::clone() const {
  return std::make_unique<RememberedGrid>(*this);
}

/// Tells whether there has been a shift with the present influence coefficients.
bool RememberedGrid::has_shifted() const {
  return standing_ && standing_->version() == row_.response().version();
}

/// Makes the row of shifts on first use.
StandingRow& RememberedGrid::standing() {
  if (!has_shifted()) standing_.emplace(row_.response(), row_.edges(), traction_bound_, problem_x_);
  return *standing_;
}

VectorXd RememberedGrid::traction_at_nodes(const TransientState& state) const {
  const Index n = x_.size();
  if (!state.scale.carries()) return VectorXd::Zero(n);
  const VectorXd x = memory_.backward ? mirrored(problem_x_) : problem_x_;
  VectorXd at_nodes = state.scale.bound * bound_at(traction_bound_, x);
  if (ratio_.size() > 0) at_nodes = at_nodes.cwiseProduct(ratio_);
  const LeadingEdgeConstants& edge = row_.edges().constants();
  VectorXd values(n);
  for (Index i = 0; i < n; ++i) {
    const Zone zone = state.zones[static_cast<std::size_t>(i)];
    const Index behind_last = memory_.backward ? i : n - 1 - i;
    values[i] = zone == Zone::adhesion ? std::clamp(state.traction[i] / edge.value(behind_last, 0),
                                                    -at_nodes[i], at_nodes[i])
                                       : static_cast<double>(zone) * at_nodes[i];
  }
  return values;
}

VectorXd RememberedGrid::displacement(const VectorXd& traction) {
  if (!memory_.scale.carries()) return VectorXd::Zero(traction.size());
  row_.set_half_width(memory_.scale.half_width);
  const VectorXd scaled = memory_.scale.half_width * traction;
  return memory_.backward ? mirrored(row_.response().displaced_by(mirrored(scaled)))
                          : row_.response().displaced_by(scaled);
}

void RememberedGrid::set_speed(double speed) {
  if (row_.friction()) row_.friction()->set_speed(speed);
}

void RememberedGrid::set_contact(const ContactScale& scale) {
  require_lasting(scale);
  const Kernel& kernel = row_.response().kernel();
  if (scale.half_width != 1) require_half_space(kernel, "a contact that changes its half-width");
  require(scale.half_width >= 0, "half_width_factor", scale.half_width, "a number >= 0");
  require(scale.bound >= 0, "bound_factor", scale.bound, "a number >= 0");
  if (scale.carries()) require_definite(kernel, scale.half_width * reach_);
  target_ = scale;
}

/// Begins with tractions of another grid: the nodes keep the ratio of tractions to the bound.
void RememberedGrid::start_from(const VectorXd& traction, TransientState& state) {
  const VectorXd ratio = ratio_to_bound(traction_bound_, problem_nodes_, traction);
  row_.face(false);
  row_.set_bound(target_);
  if (target_.carries()) row_.set_half_width(target_.half_width);
  memory_ = row_.started(row_.bound().cwiseProduct(interpolated(problem_nodes_, ratio, problem_x_)),
                         target_);
  const ContactState contact{
      .traction = memory_.traction, .slip = VectorXd::Zero(x_.size()), .zones = memory_.zones};
  fill_state(0, contact, 1, row_.bound(), row_.bound(), state);
  give_tractions(memory_, state);
  place_nodes();
}

/// Writes the tractions on the present contact into a state: the mean over partitions.
void RememberedGrid::give_tractions(const RowMemory& now, TransientState& state) const {
  state.scale = now.scale;
  state.force = weights_.dot(now.traction);
  state.traction = now.traction;
  if (now.scale.half_width > 0) state.traction /= now.scale.half_width;
}

/// Places nodes and bound where they are after a step.
void RememberedGrid::place_nodes() {
  if (placed_ == memory_.scale && placed_backward_ == memory_.backward) return;
  placed_ = memory_.scale;
  placed_backward_ = memory_.backward;
  x_ = placed_.half_width * problem_x_;
  row_.face(memory_.backward);
  bound_ = placed_.bound * row_.response().bound();
  if (!placed_backward_) return;
  x_ = mirrored(x_);
  std::ranges::reverse(bound_);
}

/// The memory of a contact that was lost and returns within the step where it returns: a tiny one,
/// which grows on the way. Its material is unstrained.
RowMemory RememberedGrid::begun_contact() {
  constexpr double tiny = 1e-9;
  ContactScale first = memory_.scale;
  if (!(first.half_width > 0)) first.half_width = tiny * target_.half_width;
  if (!(first.bound > 0)) first.bound = tiny * target_.bound;
  row_.face(memory_.backward);
  row_.set_half_width(first.half_width);
  row_.set_bound(first);
  RowMemory begun = row_.started(VectorXd::Zero(x_.size()), first);
  begun.distance = begun.origin = memory_.distance;
  return begun;
}

/// Where a step begins: in the memory, but for a contact that returns or turns round.
/// \param load  over the length of the step
const RowMemory& RememberedGrid::start_of(double length, const Load& load, bool backward) {
  const bool returns = length > 0 && !memory_.scale.carries() && target_.carries() &&
                       std::holds_alternative<PrescribedCreepage>(load);
  const bool turns = backward != memory_.backward;
  if (returns) start_ = begun_contact();
  if (turns) start_ = row_.turned(returns ? start_ : memory_);
  return returns || turns ? start_ : memory_;
}

/// Goes all the way, on the contact as it changes.
void RememberedGrid::go(const Way& way, const RowMemory& from) {
  if (from.shifts) {
    row_.set_bound(from.scale);
    ShiftMemory::end(row_.step().memory, row_.bound());
  }
  if (from.scale.carries() && target_.carries()) {
    row_.roll(way, from, target_);
  } else {
    row_.replace(way, from, target_);
  }
}

/// Requires a force that a contact carries, before the mirrored one is solved.
void RememberedGrid::require_carried_back(const Prescribed& load) const {
  if (!load.by_force) return;
  require_carried(load.value, target_, full_sliding_force(traction_bound_), "force");
}

/// Friction that depends on slip is solved for bodies that roll on, and without derivatives.
void RememberedGrid::require_forward(bool backward, const StepJacobian* jacobian) {
  if (!row_.friction() || (!backward && jacobian == nullptr)) return;
  throw std::invalid_argument(
      fmt::format("friction_law: expected none where {}",
                  backward ? "bodies roll back" : "derivatives of steps are asked for"));
}

/// Rolls the row, or the mirrored row if the length is negative.
void RememberedGrid::solve_step(const TransientState&, double signed_length, const Load& given,
                                TransientState& after, StepJacobian* jacobian) {
  const bool backward = signed_length < 0;
  const double length = std::abs(signed_length);
  require_forward(backward, jacobian);
  if (backward) require_carried_back(given);
  const Load load = backward ? mirrored(given) : given;
  const RowMemory& from = start_of(length, load, backward);
  row_.begin(from, jacobian != nullptr);
  go({.length = length, .load = over_length(load, length)}, from);
  const RowStep& step = row_.step();
  const RowMemory& memory = step.memory;
  ContactState& result = row_.result();
  result.rigid_slip = step.shift;
  result.zones = memory.zones;
  result.slip = (result.slip.array().abs() > memory.rounding()).select(result.slip, 0);
  fill_state(memory.distance, result, length, row_.bound(), row_.bound(), after);
  give_tractions(memory, after);
  after.has_second = row_.friction() && row_.friction()->has_second();
  after.mean_force = step.mean_force / length;
  after.dissipation = -(step.work + memory.stored - from.stored) / length;
  if (jacobian != nullptr) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr StepSlopes unknown{none, none, none, none};
    const bool is_free = target_.carries() || std::holds_alternative<PrescribedCreepage>(load);
    jacobian->by_load = is_free ? row_.tangent().by_load(after, length) : unknown;
    jacobian->by_length = target_ == from.scale ? row_.tangent().by_length(after, length) : unknown;
  }
  if (!backward) return;
  mirror(after);
  if (jacobian == nullptr) return;
  mirror(jacobian->by_load, std::holds_alternative<PrescribedForce>(load));
  mirror(jacobian->by_length, true);
}

/// Solves a shift of a contact that stays, or else a step of no length.
Shift RememberedGrid::solve_shift(const TransientState&, const ShiftLoad& given,
                                  TransientState& after) {
  if (row_.friction() && memory_.distance != 0) {
    throw std::invalid_argument("friction_law: expected none where bodies that rolled stand");
  }
  const bool stays = target_ == memory_.scale && target_.carries();
  const bool backward = memory_.backward;
  if (backward) require_carried_back(given);
  const ShiftLoad load = backward ? mirrored(given) : given;
  row_.begin(memory_, false);
  RowStep& step = row_.step();
  RowMemory& memory = step.memory;
  ContactState& result = row_.result();
  if (stays) {
    row_.set_half_width(target_.half_width);
    row_.set_bound(target_);
    step.shift = standing().shift(row_.response(), load, memory_, memory, result);
  } else {
    go({.length = 0, .load = load}, memory_);
    const bool entered = memory.entry_has_come(row_.edges().constants().offset) &&
                         sticks(memory.zones, x_.size() - 1);
    if (target_.carries() && !entered) memory.admit_entry();
  }
  const auto* distance = std::get_if<PrescribedShift>(&load);
  result.rigid_slip = distance != nullptr ? distance->value : step.shift;
  result.zones = memory.zones;
  result.traction = memory.traction;
  const VectorXd slip =
      stays ? VectorXd(row_.response().displaced_by(memory.traction - memory_.traction).array() +
                       result.rigid_slip)
            : result.slip;
  Shift shift = fill_shift(memory_.distance, memory_.traction, result, slip, row_.bound(),
                           row_.bound(), after);
  give_tractions(memory, after);
  if (!stays) {
    shift.work = -step.work;
    shift.dissipation = shift.work - (memory.stored - memory_.stored);
  }
  if (backward) {
    mirror(after);
    mirror(shift);
  }
  return shift;
}

void RememberedGrid::accept_step() {
  std::swap(memory_, row_.step().memory);
  ratio_ = memory_.friction.nodes;
  place_nodes();
}

}  // namespace microslip
