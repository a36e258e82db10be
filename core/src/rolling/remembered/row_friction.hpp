// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "../../friction/slip_friction_search.hpp"
#include "row_step.hpp"

namespace microslip {

/// The friction of a row that depends on the speed of slip. The ratios mu/mu_s are remembered by
/// the points of the material that RowMemory remembers: they travel with the material, so that
/// nothing is smeared. Between points they are linear.
class RowFriction {
 public:
  explicit RowFriction(const SlipFriction& friction)
      : friction_(friction), search_(friction.branch) {}

  /// \param speed  V of the next steps, > 0  [mm/s]
  void set_speed(double speed) { friction_.speed = speed; }

  /// Takes the bound at rest of the next substep.
  void take_bound(const Eigen::VectorXd& at_rest) { at_rest_ = at_rest; }

  /// Begins a step: none of its substeps has had a second solution yet.
  void begin() { has_second_ = false; }

  /// Solves a substep. Its conditions get the bound of the solution.
  /// \throws as SlipFrictionSearch::solve
  void solve(ActiveSet& active_set, RowStep& step, const Substep& substep);

  /// Gives the ratios of the substep that was solved last to the material, before the material
  /// moves on.
  /// \param offset  distance from the last node to the leading edge  [dx]
  void remember(RowMemory& memory, const Substep& substep, double offset) const;

  /// Whether a substep of the step has a second solution.
  bool has_second() const { return has_second_; }

 private:
  double time_of(const Substep& substep) const { return substep.length / friction_.speed; }
  void find_earlier_slip(const RowMemory& before, const Substep& substep);

  SlipFriction friction_;
  SlipFrictionSearch search_;
  Eigen::VectorXd at_rest_;   ///< bound  [N/mm^2]
  Eigen::VectorXd earlier_;   ///< slip of nodes before the substep that counts as none yet  [mm]
  Eigen::VectorXd before_;    ///< ratios with which the material has come to the nodes
  Eigen::VectorXd distance_;  ///< slipped in the substep by the nodes  [mm]
  bool has_second_ = false;
};

}  // namespace microslip
