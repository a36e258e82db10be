// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

/// Smallest slip zone, as a fraction of the half-width. Below it the force loses digits as a
/// difference to full sliding, so smaller loads scale this state: force over creepage changes by
/// about 2e-8 from there to full adhesion.
inline constexpr double least_sliding = 2e-8;

/// A steady state with one stick zone, [b, a], which ends at the leading edge, under a positive
/// creepage.
struct CreepageForce {
  double stick_edge;  ///< b, in [-a, a]  [mm]
  double creepage;    ///< w  [1]
  double force;       ///< F, negative  [N/mm]
};

/// All states with one stick zone, as a function of the stick zone's trailing end.
struct CreepageForceCurve {
  std::function<CreepageForce(double stick_edge)> at;
  double half_width;             ///< a  [mm]
  double full_sliding_creepage;  ///< the least creepage of full sliding  [1]
  double full_sliding_force;     ///< absolute value of the force of full sliding  [N/mm]
};

/// The state on the curve that meets a load.
struct LoadedState {
  CreepageForce state;
  /// The load over the load of the state with the smallest slip zone, if less than 1; otherwise 1
  /// [1]
  double scale;
  double direction;  ///< sign of the creepage, +-1
  int evaluations;   ///< number of evaluations of the curve
};

/// A steady state with the sign of the load.
class LoadedSolution {
 public:
  double creepage() const { return loaded_.direction * loaded_.state.creepage; }  ///< w  [1]
  double force() const { return loaded_.direction * loaded_.state.force; }        ///< F  [N/mm]
  double stick_edge() const { return loaded_.state.stick_edge; }  ///< b; a in full sliding  [mm]
  int evaluations() const { return loaded_.evaluations; }         ///< number of systems solved

  /// Estimate of the condition number of the equations in adhesion, in the 1-norm; 1 in full
  /// sliding
  double condition() const { return condition_; }

  /// -w F, the energy lost per mm rolled and mm width  [N/mm]
  double dissipation() const { return -loaded_.state.creepage * loaded_.state.force; }

 protected:
  explicit LoadedSolution(const LoadedState& loaded) : loaded_(loaded) {}

  LoadedState loaded_;
  double residual_ = 0;  ///< of the equations in adhesion, over the strain  [1]
  double condition_ = 1;
};

/// Finds the state that meets the load by TOMS 748, to rounding, in about ten evaluations.
/// \throws std::invalid_argument if a force is not below full sliding
/// \throws NotConverged          if the root is not found
LoadedState meet_load(const CreepageForceCurve& curve, const Load& load);

}  // namespace microslip
