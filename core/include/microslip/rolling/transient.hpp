// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/rolling/advection.hpp"
#include "microslip/rolling/evidence.hpp"
#include "microslip/rolling/material_rolling.hpp"
#include "microslip/rolling/recent_creep.hpp"

namespace microslip {

/// Transient rolling of quasi-identical bodies in 2D: s = w + (1/V) Du/Dt, thesis (3.9). The grid
/// moves with the contact, or with the material if the scheme is MaterialFixed.
struct TransientProblem {
  Kernel kernel;
  TractionBound bound;
  Grid grid;  ///< on the same [-a, a] as the bound
  Basis basis;
  AdvectionScheme scheme;
  Solver solver = {};
};

/// A transient is about displacements, and so wants a contact that resists them: with an L0 of
/// plane strain up to (a + dx)/2, half the half-length of elements that reach beyond the edges by
/// dx, a creepage would drive the force the wrong way. Steady rolling is about strains alone.
/// \throws std::invalid_argument unless definite_half_length() is above a + dx
void require_definite(const TransientProblem& problem);

/// No tractions.
struct Rest {};

/// A shift without rolling, from no tractions, until the bodies carry a force.
struct CattaneoShift {
  double force;                         ///< less in absolute value than full sliding  [N/mm]
  std::string_view key = "load.force";  ///< which gave it, for messages
};

/// The last are tractions at the N nodes, nowhere above the bound by more than 1e-3 of the largest:
/// they may have been printed with few digits  [N/mm^2]
using Start = std::variant<Rest, CattaneoShift, Eigen::VectorXd>;

/// \throws std::invalid_argument if a traction is not finite or above the bound, see Start
void require_within_bound(const Eigen::VectorXd& x, const Eigen::VectorXd& bound,
                          const Eigen::VectorXd& traction);

/// Values at the N nodes at the end of a step, and what follows from them. A positive creepage
/// gives negative tractions.
struct TransientState {
  double distance;           ///< q rolled so far  [mm]
  Eigen::VectorXd traction;  ///< coefficients of the basis  [N/mm^2]
  Eigen::VectorXd slip;      ///< relative slip s of the step; zero before the first  [1]
  std::vector<Zone> zones;
  double force;     ///< integral of the traction  [N/mm]
  double creepage;  ///< w of the step; zero before the first  [1]
  /// Mean of the creepage over the last element travelled, or since the start: it lags by half an
  /// element. Under a force, a step shorter than an element has noise, because elements begin to
  /// slip one by one. The mean has 40 to 5000 times less where an element is a whole number of
  /// steps, and 10 times less with c = 0.3. tests/unit/element_creepage_test.cpp  [1]
  double element_creepage;
  /// Energy lost per mm rolled and mm width: -integral of (p + p')/2 s over the material points,
  /// those that have just left included. On a grid fixed to the material the slip is that by A p
  /// alone, and under a prescribed creepage this is -mean_force w less the change of
  /// elastic_energy() per dq, to rounding. On one that moves with the contact that holds to 1e-3 in
  /// steady rolling with 101 nodes, with Fractional to 5 %: slip is interpolated where a node has
  /// come to. tests/unit/dissipation_test.cpp  [N/mm]
  double dissipation;
  /// The same with the tractions at the end of the step, as the thesis has it in (9.11): of first
  /// order, and too low where slip grows in the step  [N/mm]
  double end_dissipation;
  double mean_force;               ///< over the step, linear in it or in each of its parts  [N/mm]
  int iterations;                  ///< stick/slip partitions tried
  Evidence evidence;               ///< at its end; the residual is the worst of its parts
  Eigen::Index adhesion_elements;  ///< of those with a bound above zero
  Eigen::Index slip_elements;      ///< likewise
};

/// Implicit Euler steps, collocated at the nodes, thesis (3.14)-(3.16):
/// \f[ \Delta q\,s = \Delta q\,w + A\,p - A'p' \f]
///
/// A step whose partition is that of the step before costs two products and a solve, see ActiveSet,
/// which also is for others. But for the fractional scheme it allocates nothing once steps of its
/// length have been made, on a grid fixed to the material from the same places within an element.
/// Memory: N^2 numbers three to four times where matrices are dense.
/// Accuracy: the cumulative creep of a Cattaneo shift that turns to Carter's solution is of second
/// order in dx on a grid fixed to the material, whatever the steps; else of first order, as in
/// steady rolling, because of the leading edge. tests/order/transient_order_test.cpp
///
/// A copy goes on like the original, to the bit, and independently of it: in another thread, too.
/// After a step that throws the state is what it was, and later ones differ by rounding at most
/// from what they would have been. But not after std::bad_alloc: an Eigen object whose resizing
/// fails must not even be destroyed.
class TransientRolling {
 public:
  /// \throws as require_definite; as start_from_shift, if that is how it starts; as
  ///         require_within_bound for tractions
  explicit TransientRolling(const TransientProblem& problem, const Start& start = Rest{});

  // Nodes, and values at them, now. On a grid fixed to the material there are some besides behind
  // and before the contact, where the bound is zero, and all have other positions after each step.
  const Eigen::VectorXd& x() const { return x_; }          ///< in the contact's frame  [mm]
  const Eigen::VectorXd& bound() const { return bound_; }  ///< [N/mm^2]
  const TransientState& state() const { return state_; }

  // Tractions and bound as values at the nodes: the same, but on a grid that is fixed to the
  // material, where those above are means over elements and, next to the leading edge, coefficients
  // that make up for the square root there.
  Eigen::VectorXd traction_at_nodes() const;  ///< zero outside the contact  [N/mm^2]
  Eigen::VectorXd bound_at_nodes() const;     ///< [N/mm^2]

  /// A p, the displacement at the nodes  [mm]. N^2 operations.
  Eigen::VectorXd displacement() const;

  /// Half of p A p  [N]. N^2 operations.
  double elastic_energy() const;

  /// Estimate of the condition number of the equations of the last step, see ActiveSet::condition.
  double condition();

  /// Makes these the tractions, with nothing rolled. On a grid fixed to the material their ratio to
  /// the bound is interpolated.
  /// \param traction  at the nodes of the problem's grid
  /// \throws as require_within_bound
  void start_from(const Eigen::VectorXd& traction);

  /// Shifts the bodies without rolling until they carry the force, from no tractions.
  /// \return the shift  [mm]
  /// \throws as ActiveSet::solve
  double start_from_shift(const PrescribedForce& force);

  /// Rolls on.
  /// \param length  dq; dq/dx in the range of Advection::advect, or >= min_step_ratio on a grid
  ///                fixed to the material  [mm]
  /// \throws std::invalid_argument outside the range, and as ActiveSet::solve
  void step(double length, const Load& load);

  /// The state to which that step would lead.
  TransientState attempt(double length, const Load& load);

  /// Rolls a distance in steps of the given lengths, in turn; the last is shortened to end there.
  /// \param distance    (0, inf)  [mm]
  /// \param lengths     dq, at least one, each as for step()  [mm]
  /// \param after_step  called after each
  void roll(double distance, const std::vector<double>& lengths, const Load& load,
            const std::function<void(const TransientState&)>& after_step);

 private:
  void make_system();
  void begin(const ContactState& contact);
  void start_material(const MaterialState& start);
  void move_to(double distance);
  void describe(double distance, const ContactState& contact, double length,
                const Eigen::VectorXd& bound, TransientState& state) const;
  double contact_dissipation(double length) const;
  void look_ahead(double length, const Load& load);
  void look_ahead_with_contact(double length, const Load& load);
  void look_ahead_with_material(double length, const Load& load);

  TransientProblem problem_;
  Eigen::VectorXd x_;
  Eigen::VectorXd bound_;
  Eigen::VectorXd weights_;
  double spacing_;
  TransientState state_{};
  TransientState next_{};  ///< after a step that is tried
  RecentCreep creep_;

  // On a grid that moves with the contact; conditions and contact are of the step that is tried.
  std::optional<ActiveSet> active_set_;
  std::optional<Advection> advection_;
  SlipConditions conditions_;
  ContactState contact_;
  Eigen::VectorXd mean_bound_;

  // On one that is fixed to the material; the last one is the step that is tried.
  std::optional<MaterialRolling> material_;
  MaterialState material_state_;
  MaterialStep material_step_;
};

/// How many steps TransientRolling::roll takes.
std::size_t number_of_steps(double distance, const std::vector<double>& lengths);

}  // namespace microslip
