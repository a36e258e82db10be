// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "microslip/rolling/transient.hpp"

namespace microslip {

/// \file
/// A solid body of revolution rolls down a slope, thesis chapter 9: m dv/dt = F_cm + F and I
/// domega/dt = -R F, where F is the force of the contact. All quantities are per mm of width, in
/// mm, N and s.

/// The body, the force that drives it, and its initial velocity.
struct Cylinder {
  double mass;          ///< m, in (0, inf)  [N s^2/mm^2]
  double inertia;       ///< I, in (0, inf)  [N s^2]
  double radius;        ///< R, in (0, inf)  [mm]
  double slope_force;   ///< F_cm, gravity along the slope, in (0, inf)  [N/mm]
  double velocity = 0;  ///< v at the start, where the body rolls freely, in [0, inf)  [mm/s]
};

/// Coupling of contact and motion in a step. The contact needs the step's distance and shift, and
/// gives the force at the end of the step.
enum class Integrator {
  verlet,    ///< velocity Verlet with predicted velocities, Groot and Warren's lambda = 1/2
  leapfrog,  ///< velocities half a step ahead of positions, with varying steps
  /// Mean velocities move the contact, and the mean of the forces before and after the step moves
  /// the body. The rule is implicit; with Remembered the energy balance is exact.
  midpoint
};

/// Energies per mm of width, as changes since the start  [N]
struct EnergyLedger {
  double potential = 0;       ///< -F_cm X, thesis (9.7)
  double translation = 0;     ///< of m v^2/2
  double rotation = 0;        ///< of I omega^2/2
  double elastic = 0;         ///< half the integral of p u
  double dissipated = 0;      ///< TransientState::dissipation
  double end_dissipated = 0;  ///< thesis (9.11), from the tractions at the end of each step

  /// The sum of energies with `dissipated` or with `end_dissipated`; constant in theory.
  double total() const { return motion() + dissipated; }
  double end_total() const { return motion() + end_dissipated; }

 private:
  double motion() const { return potential + translation + rotation + elastic; }
};

/// The motion after a step.
struct CylinderState {
  double time = 0;              ///< [s]
  double position = 0;          ///< X rolled  [mm]
  double velocity = 0;          ///< v, at the position's time for all integrators  [mm/s]
  double angular_velocity = 0;  ///< omega  [1/s]
  double force = 0;             ///< F  [N/mm]
  double creepage = 0;          ///< (v - omega R)/v of the step  [1]
};

/// \throws std::invalid_argument unless in (0, 1]
void require_tolerance(double tolerance);

/// A cylinder that starts from rest, or from free rolling. A step lasts c dx / v, but no longer
/// than the fraction c dx/a of two times. The first is the period in which the body swings on a
/// sticking contact, 2 pi sqrt(m_r/stiffness), with 1/m_r = 1/m + R^2/I.
/// The second is the time in which F_cm moves the body by a from rest. The fraction is limited to
/// 1/8 of the period and to 1 of the second time. It is proportional to dx, because the motion
/// would otherwise be of lower order.
///
/// Order of accuracy: second in dx for v, omega and X where c dx is below a/8, with any integrator
/// and c. This holds with Remembered. With Direct the motion is of first order, as the contact is;
/// with c = 1 the error due to the time step is the larger one up to N of about 100
/// (tests/order/motion_order_test.cpp, tests/study/energy_balance_test.cpp). Cost of a step: one
/// transient step, or about three with the midpoint rule.
class RollingCylinder {
 public:
  /// \param contact     driven by creepage, so that kernel.width or kernel.length matters
  /// \param step_ratio  c, > 0  [1]
  /// \param tolerance   for the midpoint rule: tolerated error of v due to the length of time
  ///                    steps, relative to (v^2 + 2 a F_cm/m)^1/2, in (0, 1]. Steps become shorter
  ///                    than by the rule above where the estimated error is larger than the
  ///                    tolerance; the estimate is the error that v gathers in a period, and until
  ///                    the contact has rolled on by its width. Measured error: 0.1 to 3 times the
  ///                    tolerance where the tolerance shortens most steps. None: the rule above
  ///                    [1]
  /// \throws std::invalid_argument outside the ranges, and if the slope is so small that the first
  ///                               step would hardly move the body
  RollingCylinder(const TransientProblem& contact, const Cylinder& cylinder, Integrator integrator,
                  double step_ratio, std::optional<double> tolerance = {});

  /// Estimate of the number of steps for a distance from the start, as long as the contact does not
  /// slide; accurate to a fifth (tests/unit/cylinder_test.cpp).
  double steps_from_start(double distance) const;

  /// Period in which the body swings on a sticking contact  [s]
  double period() const { return period_; }

  /// Number of contact steps solved so far, trials included: the cost of the motion.
  std::size_t contact_steps() const { return contact_steps_; }

  const CylinderState& state() const { return state_; }
  const TransientRolling& contact() const { return contact_; }

  /// TransientRolling::condition of the last step.
  double condition() { return contact_.condition(); }
  EnergyLedger ledger() const;

  /// \throws std::runtime_error if the cylinder stalls or rolls backwards
  /// \throws NotConverged       as the contact; also if the implicit equation has no solution, or
  ///                            the tolerance would require steps 1000 times shorter
  void step();

 private:
  double time_step(double velocity) const;
  void roll_contact(double velocity, double angular_velocity, double time);
  void step_verlet();
  void step_leapfrog();
  void step_midpoint();

  /// A trial step of the midpoint rule with an assumed mean force.
  struct MidpointStep {
    double mean_force;        ///< [N/mm]
    double velocity;          ///< mean  [mm/s]
    double angular_velocity;  ///< mean  [1/s]
    double excess = 0;        ///< of the assumed mean force over the resulting one  [N/mm]
    double end_force = 0;     ///< [N/mm]
  };
  MidpointStep try_midpoint(double time, double mean_force);
  MidpointStep solve_midpoint(double time);
  double kept_error(double time, const MidpointStep& step) const;

  TransientRolling contact_;
  Cylinder cylinder_;
  Integrator integrator_;
  double half_width_;
  double step_ratio_;
  double step_length_;  ///< c dx
  double period_;
  double longest_step_;   ///< [s]
  double fall_velocity_;  ///< due to F_cm over the distance a, from rest  [mm/s]
  double force_scale_;    ///< full sliding  [N/mm]
  CylinderState state_;
  std::size_t contact_steps_ = 0;
  double acceleration_;
  double angular_acceleration_ = 0;
  // Leapfrog: velocities half a step ahead, and the duration of that step.
  double ahead_velocity_ = 0;
  double ahead_angular_velocity_ = 0;
  double ahead_time_ = 0;
  // Midpoint rule.
  double slope_ = 1;  ///< of the last secant, >= 1
  std::optional<double> tolerance_;
  double allowed_time_;   ///< longest next step by the tolerance  [s]
  double last_time_ = 0;  ///< of the last step  [s]
  double last_rate_ = 0;  ///< rate of the force in the last step  [N/(mm s)]
  double dissipated_ = 0;
  double end_dissipated_ = 0;
};

}  // namespace microslip
