// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "microslip/rolling/shift.hpp"
#include "microslip/rolling/step_jacobian.hpp"
#include "microslip/rolling/transient_problem.hpp"

namespace microslip {

class Archive;

/// The nodes of a transient, and a step on them. TransientRolling holds the state.
class RollingGrid {
 public:
  virtual ~RollingGrid() = default;

  /// An independent grid that goes on like this one.
  virtual std::unique_ptr<RollingGrid> clone() const = 0;

  const Eigen::VectorXd& x() const { return x_; }          ///< in the contact's frame  [mm]
  const Eigen::VectorXd& bound() const { return bound_; }  ///< that tractions keep  [N/mm^2]
  /// mu/mu_s at the nodes; empty if friction does not depend on slip.
  const Eigen::VectorXd& friction_ratio() const { return ratio_; }

  /// The speed of the next steps, where friction depends on slip  [mm/s]
  virtual void set_speed(double) {}

  Eigen::VectorXd weights() const {
    return placed_.half_width * weights_;
  }  ///< of tractions, in a force  [mm]

  /// Tractions as values at the nodes; the tractions of the state are coefficients  [N/mm^2]
  virtual Eigen::VectorXd traction_at_nodes(const TransientState& state) const = 0;

  /// A times tractions at the nodes  [mm]
  virtual Eigen::VectorXd displacement(const Eigen::VectorXd& traction) = 0;

  /// As ActiveSet::condition, for the step that was solved last.
  virtual double condition() = 0;

  /// Starts from tractions, with nothing rolled.
  /// \param traction  at the nodes of the problem's grid, within the bound  [N/mm^2]
  /// \param state     out
  virtual void start_from(const Eigen::VectorXd& traction, TransientState& state) = 0;

  /// Starts from a shift without rolling: at rest before, and after the shift in the end.
  /// \param state  of start_from() no tractions; out
  /// \return the shift  [mm]
  /// \throws as solve_shift
  virtual double start_from_shift(const PrescribedForce& force, TransientState& state);

  /// The contact at the end of the next step or shift, and of a start.
  /// \throws std::invalid_argument if the scheme keeps the contact as it is
  virtual void set_contact(const ContactScale& scale);
  const ContactScale& contact() const { return target_; }

  /// Solves a shift without rolling, and stays where it is.
  /// \param before  the state now
  /// \param after   out
  /// \throws as ActiveSet::solve
  virtual Shift solve_shift(const TransientState& before, const ShiftLoad& load,
                            TransientState& after) = 0;

  /// Solves a step, and stays where it is.
  /// \param before  the state now
  /// \param length    dq  [mm]
  /// \param after     out
  /// \param jacobian  out, may be null
  /// \throws std::invalid_argument for a length outside the range, for a Jacobian by a scheme
  ///                               that has none, and as ActiveSet::solve
  virtual void solve_step(const TransientState& before, double length, const Load& load,
                          TransientState& after, StepJacobian* jacobian) = 0;

  /// Moves to the end of the step or shift that was solved last.
  virtual void accept_step() {}

  /// Takes the same place with fewer rounding errors.
  /// \param distance  rolled  [mm]
  virtual void move_to(double distance) { (void)distance; }

  /// Writes what the next step depends on, to the bit, or reads it into a new grid.
  /// \param with_solved  whether the step that was solved last belongs to it
  /// \throws std::invalid_argument if the scheme cannot be saved, and as Archive
  virtual void archive(Archive& archive, bool with_solved);

 protected:
  /// \param weights          n, > 0  [mm]
  /// \param pressure_strain  of the problem  [mm^2/N]
  RollingGrid(const Eigen::VectorXd& weights, double pressure_strain)
      : weights_(weights), pressure_strain_(pressure_strain) {}

  bool has_unlike_bodies() const { return pressure_strain_ != 0; }

  /// \throws std::invalid_argument for another contact where bodies differ in material
  void require_lasting(const ContactScale& scale) const;

  /// Fills a state from a solved contact, on the problem's contact. Dissipation and mean force are
  /// values at the end, and the creepage over an element is the creepage of the step.
  /// \param contact  with slip and shift over the length  [mm]
  /// \param bound    that its tractions kept, and its means over elements  [N/mm^2]
  void fill_state(double distance, const ContactState& contact, double length,
                  const Eigen::VectorXd& bound, const Eigen::VectorXd& mean_bound,
                  TransientState& state) const;

  /// Fills a state from a solved shift.
  /// \param before   the tractions  [N/mm^2]
  /// \param contact  with slip and shift  [mm]
  /// \param slip     by A p alone  [mm]
  Shift fill_shift(double distance, const Eigen::VectorXd& before, const ContactState& contact,
                   const Eigen::VectorXd& slip, const Eigen::VectorXd& bound,
                   const Eigen::VectorXd& mean_bound, TransientState& state) const;

  Eigen::VectorXd x_, bound_;
  Eigen::VectorXd ratio_;    ///< mu/mu_s at the nodes
  Eigen::VectorXd weights_;  ///< of the problem's contact  [mm]
  ContactScale placed_;      ///< the contact of x_ and bound_
  ContactScale target_;      ///< that at the end of the next step
  double pressure_strain_;   ///< strain by the pressure, over the bound  [mm^2/N]
};

/// \throws std::invalid_argument unless null
void require_no_jacobian(const StepJacobian* jacobian);

/// Whether the zone of an element is adhesion.
inline bool sticks(const std::vector<Zone>& zones, Eigen::Index i) {
  return zones[static_cast<std::size_t>(i)] == Zone::adhesion;
}

/// The zone of the mirrored element, where tractions have the other sign.
inline Zone mirrored(Zone zone) { return static_cast<Zone>(-static_cast<signed char>(zone)); }

/// The ratio of tractions to the bound, within -1 and 1; 0 where there is no bound.
/// \param x         places  [mm]
/// \param traction  there  [N/mm^2]
Eigen::VectorXd ratio_to_bound(const TractionBound& bound, const Eigen::VectorXd& x,
                               const Eigen::VectorXd& traction);

/// Slip where tractions reach the bound, and where that is zero; else adhesion.
std::vector<Zone> zones_at(const Eigen::VectorXd& traction, const Eigen::VectorXd& bound);

/// The grid of the problem's scheme.
/// \throws std::invalid_argument if basis, grid and scheme do not go together
std::unique_ptr<RollingGrid> rolling_grid(const TransientProblem& problem);

}  // namespace microslip
