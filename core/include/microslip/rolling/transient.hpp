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
/// Cost: two products and one solve for a step whose stick/slip partition is that of the step
/// before; otherwise see ActiveSet. Except for the fractional scheme, a step allocates nothing once
/// steps of its length have been made, with Remembered from the same places within an element.
/// Memory: N^2 numbers three to four times where matrices are dense.
/// Accuracy: the cumulative creep of a Cattaneo shift that turns to Carter's solution is of second
/// order in dx with Remembered, whatever the steps; else of first order, as in steady rolling,
/// because of the leading edge. tests/order/transient_order_test.cpp
///
/// A copy goes on like the original, to the bit, and independently of it: in another thread, too.
/// After a step that throws the state is what it was, and later ones differ by rounding at most
/// from what they would have been. This does not hold after std::bad_alloc: an Eigen object whose
/// resizing failed must not even be destroyed.
class TransientRolling {
 public:
  /// \param contact  at the start; a saved state has its own
  /// \throws as require_definite and set_contact; as start_from_shift, if that is how it starts; as
  ///         require_within_bound for tractions, and as restore for a saved state
  explicit TransientRolling(const TransientProblem& problem, const Start& start = Rest{},
                            const ContactScale& contact = {});

  TransientRolling(const TransientRolling& other);
  TransientRolling(TransientRolling&& other) noexcept;
  TransientRolling& operator=(const TransientRolling& other);
  TransientRolling& operator=(TransientRolling&& other) noexcept;
  ~TransientRolling();

  // Nodes, and values at them, now.
  const Eigen::VectorXd& x() const;      ///< in the contact's frame  [mm]
  const Eigen::VectorXd& bound() const;  ///< [N/mm^2]
  const TransientState& state() const { return state_; }

  // Tractions and bound as values at the nodes. With Remembered those above are means over elements
  // and, next to the leading edge, coefficients that make up for the square root there.
  Eigen::VectorXd traction_at_nodes() const;  ///< [N/mm^2]
  Eigen::VectorXd bound_at_nodes() const;     ///< [N/mm^2]

  /// A p, the displacement at the nodes  [mm]. N^2 operations.
  Eigen::VectorXd displacement() const;

  /// Half of p A p  [N]. N^2 operations.
  double elastic_energy() const;

  /// Estimate of the condition number of the equations of the last step, see ActiveSet::condition.
  double condition();

  /// Makes these the tractions, with nothing rolled. With Remembered their ratio to the bound is
  /// interpolated.
  /// \param traction  at the nodes of the problem's grid
  /// \throws as require_within_bound
  void start_from(const Eigen::VectorXd& traction);

  /// Shifts the bodies without rolling until they carry the force, from no tractions.
  /// \return the shift  [mm]
  /// \throws as ActiveSet::solve
  double start_from_shift(const PrescribedForce& force);

  /// The contact at the end of the next step or shift, to which it changes linearly on the way; it
  /// stays so. A start takes it, too. Scheme Remembered; others keep the contact of the problem.
  /// Where bodies do not touch at the end of a step there are no tractions then, and nothing is
  /// remembered; contact that returns begins at the end of its step, at rest or with the force.
  /// Edges that grow faster than they roll, or shrink, are felt up to half an element off.
  /// \throws std::invalid_argument for numbers < 0, for another scheme, and as require_definite
  void set_contact(const ContactScale& scale);

  /// The contact that was set last.
  const ContactScale& contact() const;

  /// Shifts the bodies without rolling, from the tractions now. The state has them afterwards with
  /// the same distance; its slip, creepages and dissipation are 0, as those are about rolling, and
  /// the energies of its evidence are those of the shift  [N].
  /// Cost: as two steps. After a shift that throws the state is what it was, as after a step.
  /// \throws std::invalid_argument for a shift that is not finite, and as ActiveSet::solve
  Shift shift(const ShiftLoad& load);

  /// Rolls on.
  /// \param length  dq; dq/dx in the range of Advection::advect, or >= min_step_ratio with
  ///                Remembered  [mm]
  /// \throws std::invalid_argument outside the range, and as ActiveSet::solve
  void step(double length, const Load& load);

  /// The state to which that step would lead. If the same step is made next, it costs nothing.
  TransientState attempt(double length, const Load& load);

  /// The same with the derivatives of that step, for the scheme Remembered. Cost: two more solves
  /// for each element that is travelled.
  /// \param jacobian  out
  /// \throws std::invalid_argument for another scheme, and as step
  TransientState attempt(double length, const Load& load, StepJacobian& jacobian);

  /// Rolls a distance in steps of the given lengths, in turn; the last is shortened to end there.
  /// If the loads change the contact, each step ends with that of its end.
  /// \param distance    (0, inf), at most that of the loads  [mm]
  /// \param lengths     dq, at least one, each as for step()  [mm]
  /// \param loads       of the distance from here on
  /// \param after_step  called after each
  void roll(double distance, const std::vector<double>& lengths, const LoadHistory& loads,
            const std::function<void(const TransientState&)>& after_step);

  /// Goes on with a run from distance 0, in the steps that it would have made from there in one go:
  /// the first one ends where one of these does.
  /// \param distance  at the end; more than that now, at most that of the loads  [mm]
  /// \param loads     of the distance from 0 on
  void roll_to(double distance, const std::vector<double>& lengths, const LoadHistory& loads,
               const std::function<void(const TransientState&)>& after_step);

  /// A text of all that the next steps depend on, a step that was attempted included: another
  /// TransientRolling that starts from it goes on to the bit like this one, on the same machine in
  /// the same build. Scheme Remembered. Nothing changes.
  /// \throws std::invalid_argument for another scheme
  std::string save();

  /// Goes on from a state of the same problem. An error leaves all as it was.
  /// \throws std::invalid_argument for a text that is none, damaged, of another version or problem
  void restore(const SavedState& saved);

 private:
  /// \param origin           from which start, distance and loads count  [mm]
  /// \param start, distance  of the steps, from the origin  [mm]
  void roll_on(double origin, double start, double distance, const std::vector<double>& lengths,
               const LoadHistory& loads,
               const std::function<void(const TransientState&)>& after_step);
  void archive(Archive& archive);
  void read(const SavedState& saved);
  void solve_step(double length, const Load& load, StepJacobian* jacobian);
  bool is_solved(double length, const Load& load) const;

  TransientProblem problem_;
  std::unique_ptr<RollingGrid> grid_;
  TransientState state_{};
  TransientState next_{};                          ///< after a step that is tried
  std::optional<std::pair<double, Load>> solved_;  ///< length and load of the step to next_
};

/// -dF/dS of a shift S so small that nothing slips  [N/mm^2]
double stiffness(const TransientProblem& problem);

/// How many steps TransientRolling::roll takes, or with a distance at the start roll_to().
/// \param start  in [0, distance)  [mm]
std::size_t number_of_steps(double distance, const std::vector<double>& lengths, double start = 0);

/// The end of the step that ends at a distance but for rounding, or else the distance: where a run
/// has to end for another one to go on with the same bits as one run.
double end_of_whole_steps(double distance, const std::vector<double>& lengths);

/// The distance that has been rolled in a saved state.
/// \throws std::invalid_argument as TransientRolling::restore
double distance_of(const SavedState& saved, const TransientProblem& problem);

}  // namespace microslip
