// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/dynamics/cylinder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

void require_rolling(double velocity, const CylinderState& state) {
  if (velocity > 0) return;
  throw std::runtime_error(
      fmt::format("the cylinder stalls or rolls backwards after {} mm: a step with v = {} mm/s",
                  format_short(state.position), format_short(velocity)));
}

/// Least first step. Shorter steps have not been tested, and the first step is not the shortest
/// [dx]
constexpr double least_first_step = 1e-12;

/// Least step under a tolerance. If the tolerance requires shorter steps, the force is not smooth
/// enough for it.
constexpr double least_step = 1e-3;  // as a fraction of the step with c = 1

}  // namespace

void require_tolerance(double tolerance) {
  require(tolerance > 0 && tolerance <= 1, "motion tolerance", tolerance,
          "a number above 0, at most 1");
}

RollingCylinder::RollingCylinder(const TransientProblem& contact, const Cylinder& cylinder,
                                 Integrator integrator, double step_ratio,
                                 std::optional<double> tolerance)
    : contact_(contact),
      cylinder_(cylinder),
      integrator_(integrator),
      half_width_(contact.grid.half_width()),
      step_ratio_(step_ratio),
      step_length_(step_ratio * contact.grid.spacing()),
      force_scale_(full_sliding_force(contact.contact.bound)),
      acceleration_(cylinder.slope_force / cylinder.mass),
      tolerance_(tolerance) {
  require_positive("mass", cylinder.mass);
  require_positive("inertia", cylinder.inertia);
  require_positive("cylinder radius", cylinder.radius);
  require_positive("slope_force", cylinder.slope_force);
  require(std::isfinite(cylinder.velocity) && cylinder.velocity >= 0, "velocity", cylinder.velocity,
          "a finite number >= 0");
  require_positive("step_ratio", step_ratio);
  if (tolerance) {
    require_tolerance(*tolerance);
    require(integrator == Integrator::midpoint, "motion tolerance", *tolerance,
            "none, except for the midpoint rule");
  }
  const double mass =
      1 / (1 / cylinder.mass + cylinder.radius * cylinder.radius / cylinder.inertia);
  period_ = 2 * std::numbers::pi * std::sqrt(mass / stiffness(contact));
  allowed_time_ = period_;
  const double part = step_length_ / half_width_;
  const double fall = std::sqrt(2 * half_width_ * cylinder.mass / cylinder.slope_force);
  fall_velocity_ = fall * cylinder.slope_force / cylinder.mass;
  longest_step_ = std::min(std::min(0.125, part) * period_, std::min(1.0, part) * fall);
  state_.velocity = cylinder.velocity;
  state_.angular_velocity = cylinder.velocity / cylinder.radius;
  ahead_time_ = time_step(cylinder.velocity);
  ahead_velocity_ = cylinder.velocity + acceleration_ * ahead_time_ / 2;
  ahead_angular_velocity_ = state_.angular_velocity;
  const double first_step = ahead_velocity_ * ahead_time_ / contact.grid.spacing();
  require(first_step >= least_first_step, "slope_force", cylinder.slope_force, [&] {
    return fmt::format(
        "a force that moves the cylinder by at least {} elements, not {}, in {} s, a fraction of "
        "its "
        "period on the contact",
        format_short(least_first_step), format_short(first_step), format_short(ahead_time_));
  });
}

/// As long as the body is slow, all steps have the same duration; afterwards all have the same
/// length.
double RollingCylinder::steps_from_start(double distance) const {
  const double rolling_mass =
      cylinder_.mass + cylinder_.inertia / (cylinder_.radius * cylinder_.radius);
  const double acceleration = cylinder_.slope_force / rolling_mass;
  const double start = cylinder_.velocity;
  const double fast = std::max(start, step_length_ / longest_step_);
  const double slow = std::min(distance, (fast - start) * (fast + start) / (2 * acceleration));
  const double slow_time =
      2 * slow / (start + std::hypot(start, std::sqrt(2 * acceleration * slow)));
  return (slow > 0 ? slow_time / longest_step_ : 0) + (distance - slow) / step_length_;
}

double RollingCylinder::time_step(double velocity) const {
  return velocity * longest_step_ > step_length_ ? step_length_ / velocity : longest_step_;
}

/// Moves the contact with these velocities, and computes accelerations from the force at the end.
void RollingCylinder::roll_contact(double velocity, double angular_velocity, double time) {
  require_rolling(velocity, state_);
  const double length = velocity * time;
  const double creepage = 1 - cylinder_.radius * angular_velocity / velocity;
  contact_.step(length, PrescribedCreepage{creepage});
  dissipated_ += contact_.state().dissipation * length;
  end_dissipated_ += contact_.state().end_dissipation * length;
  state_.time += time;
  state_.position += length;
  state_.creepage = creepage;
  state_.force = contact_.state().force;
  acceleration_ = (cylinder_.slope_force + state_.force) / cylinder_.mass;
  angular_acceleration_ = -cylinder_.radius * state_.force / cylinder_.inertia;
}

void RollingCylinder::step_verlet() {
  const double time = time_step(state_.velocity);
  ++contact_steps_;
  const double before = acceleration_, angular_before = angular_acceleration_;
  roll_contact(state_.velocity + time * before / 2,
               state_.angular_velocity + time * angular_before / 2, time);
  state_.velocity += time * (before + acceleration_) / 2;
  state_.angular_velocity += time * (angular_before + angular_acceleration_) / 2;
}

void RollingCylinder::step_leapfrog() {
  ++contact_steps_;
  roll_contact(ahead_velocity_, ahead_angular_velocity_, ahead_time_);
  state_.velocity = ahead_velocity_ + ahead_time_ * acceleration_ / 2;
  state_.angular_velocity = ahead_angular_velocity_ + ahead_time_ * angular_acceleration_ / 2;
  ahead_time_ = time_step(state_.velocity);
  ahead_velocity_ = state_.velocity + ahead_time_ * acceleration_ / 2;
  ahead_angular_velocity_ = state_.angular_velocity + ahead_time_ * angular_acceleration_ / 2;
}

/// Makes the contact's step with an assumed mean force. The result has the excess of the assumed
/// mean force over the resulting one.
RollingCylinder::MidpointStep RollingCylinder::try_midpoint(double time, double mean_force) {
  const double half = time / 2;
  const double velocity_slope = half / cylinder_.mass;
  const double angular_slope = -half * cylinder_.radius / cylinder_.inertia;
  MidpointStep step{
      .mean_force = mean_force,
      .velocity = state_.velocity + velocity_slope * (cylinder_.slope_force + mean_force),
      .angular_velocity = state_.angular_velocity + angular_slope * mean_force};
  require_rolling(step.velocity, state_);
  const double creepage = 1 - cylinder_.radius * step.angular_velocity / step.velocity;
  const TransientState after = contact_.attempt(step.velocity * time, PrescribedCreepage{creepage});
  ++contact_steps_;
  step.excess = mean_force - after.mean_force;
  step.end_force = after.force;
  return step;
}

/// The unknown is the mean force. A larger mean force makes the contact slide further, and so makes
/// the force at the end smaller: the equation has one solution. The solution is found by secants,
/// which start from the last rate of the force; for one unknown, derivatives of the step cost more
/// than they save.
RollingCylinder::MidpointStep RollingCylinder::solve_midpoint(double time) {
  // A trial force may brake so much that the cylinder would roll backwards.
  const auto towards = [&](double from, double to) {
    const double impulse = time / (2 * cylinder_.mass);
    const auto rolls = [&](double force) {
      return state_.velocity + impulse * (cylinder_.slope_force + force) > 0;
    };
    for (int k = 0; k < 60 && !rolls(to); ++k) to = (from + to) / 2;
    return to;
  };
  // The excess is a difference of forces; when the excess no longer falls, only rounding errors are
  // left.
  constexpr int most_trials = 100;
  const double rounding = 1e-14 * force_scale_;
  const double accepted = 1e-11 * force_scale_;
  MidpointStep before =
      try_midpoint(time, towards(state_.force, state_.force + last_rate_ * time / 2));
  for (int k = 1; std::abs(before.excess) > rounding; ++k) {
    if (k == most_trials) {
      throw NotConverged("cylinder: midpoint rule", k, std::abs(before.excess) / force_scale_);
    }
    const double next = before.mean_force - before.excess / slope_;
    const MidpointStep step = try_midpoint(time, towards(before.mean_force, next));
    const double change = step.excess - before.excess;
    if (change != 0) slope_ = std::max(1.0, change / (step.mean_force - before.mean_force));
    const bool stagnates = std::abs(step.excess) >= std::abs(before.excess);
    before = step;
    if (stagnates && std::abs(step.excess) <= accepted) break;
  }
  return before;
}

/// Estimate of the error of v, over the scale of v, if all steps were like this one for as long as
/// the contact remembers an error: for a period, and until the contact has rolled on by its width.
/// The midpoint rule assumes a force linear in the step, with the error dt^3 F''/(12 m). Before the
/// first step the force is assumed constant.
double RollingCylinder::kept_error(double time, const MidpointStep& step) const {
  const double rate = (step.end_force - state_.force) / time;
  const double curvature = 2 * (rate - last_rate_) / (time + last_time_);
  const double scale = std::hypot(state_.velocity, fall_velocity_);
  const double kept = period_ + 2 * half_width_ / scale;
  return std::abs(curvature) * time * time * kept / (12 * cylinder_.mass * scale);
}

void RollingCylinder::step_midpoint() {
  const double wanted = time_step(state_.velocity);
  const double shortest = least_step * wanted * std::min(1.0, 1 / step_ratio_);
  double time = std::min(wanted, allowed_time_);
  MidpointStep step = solve_midpoint(time);
  for (int tries = 1; tolerance_; ++tries) {
    const double error = kept_error(time, step);
    allowed_time_ = time * std::clamp(0.9 * std::sqrt(*tolerance_ / error), 0.2, 2.0);
    if (error <= *tolerance_) break;
    time = allowed_time_;
    if (time < shortest) {
      throw NotConverged(
          fmt::format(
              "motion tolerance = {}: the force of the contact is not smooth enough for it, "
              "steps would be a thousandth of those with the step ratio 1,",
              format_short(*tolerance_)),
          tries, error);
    }
    step = solve_midpoint(time);
  }
  const double before = state_.force;
  roll_contact(step.velocity, step.angular_velocity, time);
  state_.velocity += time * (cylinder_.slope_force + step.mean_force) / cylinder_.mass;
  state_.angular_velocity -= time * cylinder_.radius * step.mean_force / cylinder_.inertia;
  last_rate_ = (state_.force - before) / time;
  last_time_ = time;
}

void RollingCylinder::step() {
  switch (integrator_) {
    case Integrator::verlet:
      return step_verlet();
    case Integrator::leapfrog:
      return step_leapfrog();
    case Integrator::midpoint:
      return step_midpoint();
  }
}

EnergyLedger RollingCylinder::ledger() const {
  const double v = state_.velocity, start = cylinder_.velocity;
  const double omega = state_.angular_velocity, start_omega = start / cylinder_.radius;
  EnergyLedger ledger;
  ledger.potential = -cylinder_.slope_force * state_.position;
  ledger.translation = cylinder_.mass * (v - start) * (v + start) / 2;
  ledger.rotation = cylinder_.inertia * (omega - start_omega) * (omega + start_omega) / 2;
  ledger.elastic = contact_.elastic_energy();
  ledger.dissipated = dissipated_;
  ledger.end_dissipated = end_dissipated_;
  return ledger;
}

}  // namespace microslip
