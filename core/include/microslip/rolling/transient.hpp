// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/shift.hpp"
#include "microslip/rolling/step_jacobian.hpp"
#include "microslip/rolling/transient_problem.hpp"

namespace microslip {

class Archive;
class RollingGrid;

/// Implicit Euler steps, collocated at the nodes, thesis (3.14)-(3.16):
/// \f[ \Delta q\,s = \Delta q\,w + A\,p - A'p' \f]
///
/// Cost: two products and one solve if the stick/slip partition is unchanged from the previous
/// step; otherwise see ActiveSet. Except for the fractional scheme, a step allocates nothing if an
/// earlier step had the same length and, with Remembered, began at the same position within an
/// element. Memory: three to four times N^2 numbers if matrices are dense. Accuracy: for a Cattaneo
/// shift that turns into Carter's solution, the cumulative creep is of second order in dx with
/// Remembered, for any steps; otherwise of first order, as in steady rolling, because of the
/// leading edge. tests/order/transient_order_test.cpp
///
/// With Remembered, bodies roll back by steps of negative length, and turn as often as they like.
/// The frame stays: x, tractions, forces and shifts keep their directions, and distances go back.
/// Creepage and slip are derivatives by the distance, w = dS/dq, so that bodies which slide the same
/// way have creepages of opposite signs on their ways forth and back; a positive creepage gives
/// positive tractions on the way back. Energies are per length rolled, |dq|. A turn keeps the force
/// and the tractions, but for interpolation of second order; nodes are those of the mirrored
/// contact on the way back, -x, as the leading edge is at the other side.
/// tests/unit/turning_test.cpp
///
/// A copy continues with the same bits as the original, and independently of it, in another thread,
/// too. A step that throws leaves the state unchanged; later states differ by rounding at most.
/// This does not hold after std::bad_alloc: an Eigen object whose resizing failed must not even be
/// destroyed.
class TransientRolling {
 public:
  /// \param contact  contact at the start; a saved state has its own contact
  /// \throws as require_definite and set_contact, and by the kind of start: as start_from_shift for
  ///         a shift, as require_within_bound for tractions, as restore for a saved state
  explicit TransientRolling(const TransientProblem& problem, const Start& start = Rest{},
                            const ContactScale& contact = {});

  TransientRolling(const TransientRolling& other);
  TransientRolling(TransientRolling&& other) noexcept;
  TransientRolling& operator=(const TransientRolling& other);
  TransientRolling& operator=(TransientRolling&& other) noexcept;
  ~TransientRolling();

  // Nodes, and current values at the nodes.
  const Eigen::VectorXd& x() const;      ///< in the contact's frame, rising; see turns  [mm]
  const Eigen::VectorXd& bound() const;  ///< [N/mm^2]
  const TransientState& state() const { return state_; }

  // Tractions and bound as values at the nodes. With Remembered, state().traction and bound() are
  // element means and, next to the leading edge, coefficients that correct for the square root
  // there.
  Eigen::VectorXd traction_at_nodes() const;  ///< [N/mm^2]
  Eigen::VectorXd bound_at_nodes() const;     ///< [N/mm^2]

  /// A p, the displacement at the nodes  [mm]. N^2 operations.
  Eigen::VectorXd displacement() const;

  /// Half of p A p  [N]. N^2 operations.
  double elastic_energy() const;

  /// Estimate of the condition number of the equations of the last step, see ActiveSet::condition.
  double condition();

  /// Sets the tractions, at rolled distance 0. With Remembered the ratio of tractions to bound is
  /// interpolated.
  /// \param traction  at the nodes of the problem's grid
  /// \throws as require_within_bound
  void start_from(const Eigen::VectorXd& traction);

  /// Shifts the bodies without rolling, from zero tractions, until they carry the force.
  /// \return the shift  [mm]
  /// \throws as ActiveSet::solve
  double start_from_shift(const PrescribedForce& force);

  /// Sets the speed of the next steps, where friction depends on slip; at first it is that of the
  /// problem. Runs whose loads have times set it to the mean of each step.
  /// \param speed  V, (0, inf)  [mm/s]
  void set_speed(double speed);

  /// Sets the contact at the end of the next step or shift. The contact changes linearly on the way
  /// there, and stays unchanged afterwards. The functions start_from...() use this contact, too.
  /// Only with the scheme Remembered; other schemes keep the contact of the problem. If the bodies
  /// do not touch at the end of a step, there are no tractions then, and nothing is remembered; a
  /// returning contact begins at the start of its step, or at its end with a force. An edge that
  /// grows faster than the contact rolls, or shrinks, is resolved to half an element.
  /// \throws std::invalid_argument for numbers < 0, for another scheme, and as require_definite
  void set_contact(const ContactScale& scale);

  /// The contact that was set last.
  const ContactScale& contact() const;

  /// Shifts the bodies without rolling, from the current tractions. Afterwards the state has the
  /// new tractions at the same distance. Its slip, creepages and dissipation are 0, as they concern
  /// rolling; the energies of its evidence are energies of the shift  [N]. Cost: as two steps. A
  /// shift that throws leaves the state unchanged, as a step does.
  /// \throws std::invalid_argument for a shift that is not finite, and as ActiveSet::solve
  Shift shift(const ShiftLoad& load);

  /// Rolls one step. A step of length 0 changes nothing, neither this state nor the next one.
  /// \param length  dq; 0, or dq/dx in the range of Advection::advect; with Remembered |dq|/dx >=
  ///                min_step_ratio, and dq < 0 rolls back  [mm]
  /// \throws std::invalid_argument outside the range, with length 0 for a force or a contact that
  ///                               differs from the present one, and as ActiveSet::solve
  void step(double length, const Load& load);

  /// The state after a step, without making the step. If the same step is made next, it costs
  /// nothing.
  TransientState attempt(double length, const Load& load);

  /// The same with derivatives of the step, for the scheme Remembered and any length but 0. Cost:
  /// two more solves for each travelled element.
  /// \param jacobian  out
  /// \throws std::invalid_argument for another scheme, and as step
  TransientState attempt(double length, const Load& load, StepJacobian& jacobian);

  /// Rolls a distance in steps of the given lengths, in turn; the last step is shortened to end at
  /// the distance. If the loads change the contact, each step ends with the contact at its end.
  /// \param distance    (0, inf), at most the distance of the loads  [mm]
  /// \param lengths     dq, at least one, each as for step()  [mm]
  /// \param loads       as functions of the distance from here on
  /// \param after_step  called after each step
  void roll(double distance, const std::vector<double>& lengths, const LoadHistory& loads,
            const std::function<void(const TransientState&)>& after_step);

  /// Continues a run that began at distance 0, with the steps of an uninterrupted run: the first
  /// step ends where a step of that run ends. Steps end where the loads turn or shift the bodies.
  /// The distances of a run that turns are those along the way; state().distance is the position.
  /// \param distance  at the end; more than the current distance, at most the loads'  [mm]
  /// \param loads     as functions of the distance from 0 on
  void roll_to(double distance, const std::vector<double>& lengths, const LoadHistory& loads,
               const std::function<void(const TransientState&)>& after_step);

  /// Functions that are called in a run.
  struct Observer {
    std::function<void(const TransientState&, std::optional<double> time)> after_step;
    /// Follows a shift without rolling: slip, creepage and dissipation of the state are 0.
    std::function<void(const TransientState&, const Shift&, std::optional<double> time)>
        after_shift = {};
  };
  void roll_to(double distance, const std::vector<double>& lengths, const LoadHistory& loads,
               const Observer& observer);

  /// A text of everything that the next steps depend on, including an attempted step. Another
  /// TransientRolling that starts from this text continues with the same bits, on the same machine
  /// in the same build. Only with the scheme Remembered. The state does not change.
  /// \throws std::invalid_argument for another scheme
  std::string save();

  /// Continues from a saved state of the same problem. An error leaves everything unchanged.
  /// \throws std::invalid_argument for a text that is not a saved state, is damaged, or belongs to
  ///                               another version or problem
  void restore(const SavedState& saved);

 private:
  /// \param origin           the point from which start, distance and loads are measured  [mm]
  /// \param start, distance  begin and end of the steps, from the origin  [mm]
  void roll_on(double origin, double start, double distance, const std::vector<double>& lengths,
               const LoadHistory& loads, const Observer& observer);
  void stand(double distance, const LoadHistory& loads, const Observer& observer);
  void archive(Archive& archive);
  void read(const SavedState& saved);
  void solve_step(double length, const Load& load, StepJacobian* jacobian);
  void require_standstill(const Load& load) const;
  bool is_solved(double length, const Load& load) const;

  TransientProblem problem_;
  std::unique_ptr<RollingGrid> grid_;
  TransientState state_{};
  TransientState next_{};                          ///< state after an attempted step
  std::optional<std::pair<double, Load>> solved_;  ///< length and load of the step to next_
};

/// -dF/dS for a shift S so small that nothing slips  [N/mm^2]
double stiffness(const TransientProblem& problem);

/// Calls an action for each step of lengths that are taken in turn, the last of which ends at the
/// distance.
/// \param start  in [0, distance); the first step ends where a step from 0 on ends  [mm]
/// \param step   begin, end and length, which is free of their rounding  [mm]
/// \throws std::invalid_argument if a length or the distance is not positive, or it is not more than
///         the start
void for_steps(double distance, const std::vector<double>& lengths, double start,
               const std::function<void(double from, double to, double length)>& step);

/// The same; a step that would pass one of some distances is divided there.
/// \param ends  ascending  [mm]
void for_steps(double distance, const std::vector<double>& lengths, double start,
               const std::vector<double>& ends,
               const std::function<void(double from, double to, double length)>& step);

/// Number of steps that TransientRolling::roll takes; with a start above 0, roll_to().
/// \param start  in [0, distance)  [mm]
std::size_t number_of_steps(double distance, const std::vector<double>& lengths, double start = 0);

/// The same, of steps that are divided at some distances.
/// \param ends  ascending  [mm]
std::size_t number_of_steps(double distance, const std::vector<double>& lengths, double start,
                            const std::vector<double>& ends);

/// Length of the last one of these steps; the distance may cut it short  [mm]
double last_step(double distance, const std::vector<double>& lengths, double start = 0);

/// The end of the step that ends at a distance except for rounding; the distance if there is no
/// such step. A run that ends there can be continued with the same bits as an uninterrupted run.
double end_of_whole_steps(double distance, const std::vector<double>& lengths);

/// The rolled distance of a saved state.
/// \throws std::invalid_argument as TransientRolling::restore
double distance_of(const SavedState& saved, const TransientProblem& problem);

}  // namespace microslip
