// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "element_travel.hpp"
#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/spectrum/leading_edge.hpp"
#include "rolling_grid.hpp"
#include "stick_slip_point.hpp"

namespace microslip {

/// The displacements that the material remembers, and the state from which a step starts.
///
/// A displacement is that of a material point by the tractions when it came, less the rigid shift
/// since: the displacement that it has now if it has stuck. There are N + 1 of them: one for each
/// node, and one for the entry, which is one element ahead of the last node.
struct RememberedState : ElementTravel {
  /// At the points of the material that were at nodes and entry when the last whole element had
  /// been travelled, as if points next to the stick-slip point had not slipped  [mm]
  Eigen::VectorXd points;
  Eigen::VectorXd nodes;  ///< at the nodes and the entry now  [mm]

  Eigen::VectorXd traction;  ///< N, the mean over partitions  [N/mm^2]
  std::vector<Zone> zones;   ///< of the partition that meets the conditions
  Eigen::Index stuck = 0;    ///< the first node in adhesion; N if there is none
  double stored = 0;         ///< energy of the bodies  [N]
  Eigen::Index kept = 0;     ///< points from here on are as if they had not slipped
  double lead = 0;           ///< shift of the mean over partitions before that of `zones`  [mm]
};

/// Nodes that stand in the contact, constant functions. The material remembers the displacement
/// with which it came: s = W + A p - m, where m is the displacement that it would have without
/// slip, cubic between points one element apart.
///
/// - Both edges of the contact lie where the scheme feels them: LeadingEdgeConstants::offset
///   elements before the last node and half an element less behind the first.
/// - A displacement is remembered where a point enters, one element before the last node, once per
///   element. Steps in between have no part in what is remembered of adhesion, so that results do
///   not depend on the step.
/// - StickSlipPoint gives the mean of the solutions of four partitions, so that the stick-slip
///   point moves evenly through the elements.
/// - Where the leading edge sticks, a shift without rolling is singular there, and of first order,
///   except for the start: it has an element at the entry besides.
///
/// Cost: a step is a solve of ActiveSet for each part that ends where an element has been travelled
/// or with the step, and where the partition changes, a solve for each of four neighbours of the
/// stick-slip point. Nothing is allocated where partitions are those of steps before.
/// Accuracy: second order in dx, of small changes of the load, too; docs/theory.md,
/// tests/order/small_motion_test.cpp, tests/unit/remembered_rolling_test.cpp
class RememberedGrid final : public RollingGrid {
 public:
  /// \throws std::invalid_argument for offsets of the grid other than 1/2, and fewer than 4 nodes
  explicit RememberedGrid(const TransientProblem& problem);

  std::unique_ptr<RollingGrid> clone() const override;
  Eigen::VectorXd traction_at_nodes(const TransientState& state) const override;
  void start_from(const Eigen::VectorXd& traction, TransientState& state) override;
  double start_from_shift(const PrescribedForce& force, TransientState& state) override;
  Shift solve_shift(const TransientState& before, const Load& load, TransientState& after) override;
  void solve_step(const TransientState& before, double length, const Load& load,
                  TransientState& after, StepJacobian* jacobian) override;
  void accept_step() override;
  void move_to(double distance) override;

 private:
  RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge);
  RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
                 const Grid& grid);

  /// A step on its way through its parts, each of which ends where an element has been travelled or
  /// with the step; or a derivative of it. Given the partition, all is linear except for products
  /// of force and displacement.
  struct Step : RolledContact {
    RememberedState state;      ///< at the end of the part
    SlipConditions conditions;  ///< of the part
    double moved = 0;           ///< shift by the partition in the part, with the lead  [mm]
    double creepage = 0;        ///< shift by the mean in the part  [mm]
    double part_force = 0;      ///< mean of the force over the part  [N/mm]

    // Summed over the parts.
    double shift = 0;       ///< [mm]
    double mean_force = 0;  ///< [N]
    double work = 0;        ///< of the force  [N]
  };

  /// A part of a step.
  struct Part {
    double length;                    ///< [mm]
    double end;                       ///< the distance at its end  [mm]
    Load load;                        ///< its creepage is the shift  [mm]
    std::array<Load, 2> load_slopes;  ///< by load and length of the step
    bool is_last;
  };

  void begin(const Eigen::VectorXd& traction, TransientState& state);
  void remember_all(RememberedState& state) const;
  double displacement_at_entry(const Eigen::VectorXd& traction) const;

  void begin_step(bool with_slopes);
  void roll_part(const Part& part);
  template <class Interpolation>
  double remembered_at(const RememberedState& state, Eigen::Index i, double phase, double travelled,
                       const Interpolation& value) const;
  void recall(Step& step, double phase, double travelled) const;
  static Load of_partition(const Load& load, const Step& step);
  void search_partition(const Load& load);
  void solve_slopes(const Part& part, double phase, double travelled);
  void admit_slip(RememberedState& state) const;
  void add_slip(double travelled);
  void displace(Step& step) const;
  void finish_part(Step& step, const Part& part, double phase, bool stuck_again) const;
  void remember(RememberedState& state, double phase, bool stuck_again) const;
  StepSlopes slopes_of_step(const Step& slope, const TransientState& after, double length,
                            double by_length) const;

  TractionBound traction_bound_;
  Eigen::VectorXd problem_nodes_;  ///< [mm]
  double spacing_;                 ///< [mm]
  LeadingEdgeConstants edge_;
  Eigen::VectorXd entry_influence_;  ///< displacement at the entry by each node  [mm^3/N]
  Kernel kernel_;
  Solver solver_;
  StickSlipPoint stick_slip_point_;

  RememberedState state_;
  Step next_;                   ///< that was solved last
  std::array<Step, 2> slopes_;  ///< of it, by its load and by its length
  bool has_slopes_ = false;
  ContactState sum_;  ///< of its partition, slip and creepage as displacements  [mm]
};

}  // namespace microslip
