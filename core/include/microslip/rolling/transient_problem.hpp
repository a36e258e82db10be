// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/linalg/solver.hpp"
#include "microslip/rolling/advection.hpp"
#include "microslip/rolling/contact.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

/// Transient rolling in 2D: s = w + (1/V) Du/Dt, thesis (3.9). The grid stands in the contact.
/// Bodies of different material begin with no tractions under their pressure, which stands in the
/// contact, and the contact does not change.
struct TransientProblem {
  Contact contact;
  Grid grid;  ///< on the same [-a, a] as the bound
  Basis basis;
  AdvectionScheme scheme;
  Solver solver = {};
  Acceptance accepted = {};  ///< for require_evidence
  /// Friction that depends on slip: the contact's bound is that at rest. Shifts have no speed, so
  /// that they keep the bound at rest.
  std::optional<SlipFriction> friction = std::nullopt;
};

/// \throws std::invalid_argument for a contact that is not valid; and for friction that depends on
///         slip, but with the schemes Remembered and, without a memory of friction, Direct
void validate(const TransientProblem& problem);

/// A transient is about displacements, and so wants a contact that resists them: with an L0 of
/// plane strain up to (a + dx)/2, half the half-length of elements that reach beyond the edges by
/// dx, a creepage would drive the force the wrong way. Steady rolling is about strains alone.
/// \throws std::invalid_argument unless definite_half_length() is above a + dx
void require_definite(const TransientProblem& problem);

/// The same for a contact.
/// \param reach  a + dx  [mm]
void require_definite(const Kernel& kernel, double reach);

/// No tractions.
struct Rest {};

/// A shift without rolling, from no tractions, until the bodies carry a force.
struct CattaneoShift {
  double force;  ///< less in absolute value than full sliding  [N/mm]
};

/// The text of TransientRolling::save().
struct SavedState {
  std::string text;
};

/// Tractions are those at the N nodes, nowhere above the bound by more than 1e-3 of the largest:
/// they may have been printed with few digits  [N/mm^2]
using Start = std::variant<Rest, CattaneoShift, Eigen::VectorXd, SavedState>;

/// \throws std::invalid_argument if a traction is not finite or above the bound, see Start
void require_within_bound(const Eigen::VectorXd& x, const Eigen::VectorXd& bound,
                          const Eigen::VectorXd& traction);

/// Values at the N nodes at the end of a step, or at standstill, before the first one and after a
/// shift, and what follows from them. A positive creepage gives negative tractions on the way
/// forth, and positive ones on the way back, where dq < 0.
struct TransientState {
  double distance;           ///< q, less what has been rolled back  [mm]
  ContactScale scale = {};   ///< of the contact, over the problem's contact
  Eigen::VectorXd traction;  ///< coefficients of the basis  [N/mm^2]
  Eigen::VectorXd slip;      ///< s, over dq of either sign; zero at standstill  [1]
  std::vector<Zone> zones;
  double force;     ///< integral of the traction  [N/mm]
  double creepage;  ///< w = dS/dq of the step; zero at standstill  [1]
  /// Energy lost per mm rolled and mm width. With Remembered it is the work of the force less the
  /// change of elastic_energy(), over |dq|. With the other schemes it is -integral of (p + p')/2 s
  /// over the material points, including points that have just left, for which slip is
  /// interpolated. The two are equal in theory. In steady rolling with 101 nodes they differ by
  /// 1e-3, with Fractional by 5 % (tests/unit/dissipation_test.cpp)  [N/mm]
  double dissipation;
  /// The same with the tractions at the end of the step, as the thesis has it in (9.11): of first
  /// order, and too low where slip grows in the step  [N/mm]
  double end_dissipation;
  double mean_force;               ///< over the step, linear in it or in each of its parts  [N/mm]
  int iterations;                  ///< stick/slip partitions tried
  Evidence evidence;               ///< at its end; the residual is the worst of its parts
  Eigen::Index adhesion_elements;  ///< of those with a bound above zero
  Eigen::Index slip_elements;      ///< likewise
  /// Whether a part of the step has another solution with faster or slower slip, where friction
  /// depends on slip.
  bool has_second = false;
};

}  // namespace microslip
