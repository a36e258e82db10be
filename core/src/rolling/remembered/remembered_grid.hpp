// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "../rolling_grid.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "rolling_row.hpp"
#include "standing_row.hpp"

namespace microslip {

/// A grid whose nodes stand in the contact, with constant functions. The material remembers the
/// displacement with which it came: s = S + A p - U, where U is the displacement that the material
/// would have without slip.
///
/// - RowEdges: both edges of the contact lie where the scheme feels them.
/// - RowMemory: the displacements that the material remembers, and how far it has travelled.
/// - RollingRow: a step as substeps, with the mean over partitions; StepTangent: its derivatives.
/// - StandingRow: a shift without rolling.
/// - RowResponse: displacements by tractions and by the pressure of bodies of different material.
/// - If the contact changes its size, nodes keep their places over its half-width. Points are
///   renewed at the nodes as soon as the leading or the trailing edge has travelled an element.
///
/// Accuracy: second order in dx, for small changes of the load, too; docs/theory.md,
/// tests/order/small_motion_test.cpp, tests/unit/remembered_rolling_test.cpp
class RememberedGrid final : public RollingGrid {
 public:
  /// \throws std::invalid_argument for offsets of the grid other than 1/2, and fewer than 4 nodes
  explicit RememberedGrid(const TransientProblem& problem);

  std::unique_ptr<RollingGrid> clone() const override;
  Eigen::VectorXd traction_at_nodes(const TransientState& state) const override;
  Eigen::VectorXd displacement(const Eigen::VectorXd& traction) override;
  double condition() override { return row_.response().active_set().condition(); }
  void start_from(const Eigen::VectorXd& traction, TransientState& state) override;
  Shift solve_shift(const TransientState& before, const ShiftLoad& load,
                    TransientState& after) override;
  void solve_step(const TransientState& before, double length, const Load& load,
                  TransientState& after, StepJacobian* jacobian) override;
  void accept_step() override;
  void move_to(double distance) override {
    memory_.move_to(memory_.backward ? -distance : distance);
  }
  void set_contact(const ContactScale& scale) override;
  void set_speed(double speed) override;
  void archive(Archive& archive, bool with_solved) override;

 private:
  RememberedGrid(const TransientProblem& problem, const RollingRow& row);

  bool has_shifted() const;
  StandingRow& standing();
  RowMemory begun_contact();
  const RowMemory& start_of(double length, const Load& load, bool backward);
  void go(const Way& way, const RowMemory& from);
  void give_tractions(const RowMemory& now, TransientState& state) const;
  void place_nodes();
  void require_forward(bool backward, const StepJacobian* jacobian);
  void require_carried_back(const Prescribed& load) const;

  TractionBound traction_bound_;
  Eigen::VectorXd problem_nodes_;  ///< [mm]
  Eigen::VectorXd problem_x_;      ///< of the nodes on the problem's contact  [mm]
  double reach_;                   ///< largest distance of its elements from the centre  [mm]
  RollingRow row_;
  std::optional<StandingRow> standing_;  ///< from the first shift on
  RowMemory memory_;
  RowMemory start_;       ///< of a step in which the contact returns or turns round
  bool placed_backward_;  ///< whether x_ and bound_ are those of the mirrored row
};

}  // namespace microslip
