// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "remembered_state.hpp"
#include "rolling_grid.hpp"
#include "stick_slip_point.hpp"

namespace microslip {

/// A grid whose nodes stand in the contact, with constant functions. The material remembers the
/// displacement with which it came: s = S + A p - U, where U is the displacement that the material
/// would have without slip, cubic between points one element apart.
///
/// - Both edges of the contact lie where the scheme feels them: the leading edge
///   LeadingEdgeConstants::offset elements ahead of the last node; the trailing edge so near to
///   the first node that the first element is on a spring (MeanSpring).
/// - A displacement is remembered where a point enters, one element ahead of the last node, once
///   for each element. Steps in between record no adhesion, so that results do not depend on the
///   step.
/// - StickSlipPoint gives the mean of the solutions of four partitions, so that the stick-slip
///   point moves evenly through the elements.
/// - Bodies of different material remember the displacement by the pressure, too.
/// - In a shift without rolling, an element at the entry carries traction, too, and a second mean
///   is taken at the leading end of adhesion (remembered_shift.cpp).
/// - If the contact changes its size, nodes keep their places over its half-width. Points are
///   renewed at the nodes as soon as the leading or the trailing edge has travelled an element. In
///   plane strain, another half-width has the same response and a common compliance, which shifts
///   the whole contact in proportion to the force; a strip needs a new response.
///
/// Cost: a solve of ActiveSet for each substep; a substep ends where an element has been travelled
/// or with the step. Where the partition changes, four neighbours of the stick-slip point are
/// solved, too. Nothing is allocated if the partitions have been met in earlier steps.
/// Accuracy: second order in dx, for small changes of the load, too; docs/theory.md,
/// tests/order/small_motion_test.cpp, tests/unit/remembered_rolling_test.cpp
class RememberedGrid final : public RollingGrid {
 public:
  /// \throws std::invalid_argument for offsets of the grid other than 1/2, and fewer than 4 nodes
  explicit RememberedGrid(const TransientProblem& problem);

  std::unique_ptr<RollingGrid> clone() const override;
  Eigen::VectorXd traction_at_nodes(const TransientState& state) const override;
  void start_from(const Eigen::VectorXd& traction, TransientState& state) override;
  Shift solve_shift(const TransientState& before, const ShiftLoad& load,
                    TransientState& after) override;
  void solve_step(const TransientState& before, double length, const Load& load,
                  TransientState& after, StepJacobian* jacobian) override;
  void accept_step() override;
  void move_to(double distance) override;
  void set_contact(const ContactScale& scale) override;
  Eigen::VectorXd displacement(const Eigen::VectorXd& traction) override;
  void archive(Archive& archive, bool with_solved) override;

 private:
  RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge);
  RememberedGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
                 const Grid& grid);

  /// A spring under an element, with which the solution is the mean of the solutions with and
  /// without the element.
  struct MeanSpring {
    double compliance;  ///< [mm^3/N]
    /// \param weight  of the solution with the element, in (0, 1)
    double of_mean(double weight) const { return compliance * (1 - weight) / weight; }
  };

  /// The contact in a shift without rolling: the nodes and an element at the entry. Adhesion may
  /// end anywhere within an element on either side.
  struct StandingContact {
    Eigen::VectorXd bound;    ///< its means over elements of the problem's contact  [N/mm^2]
    ActiveSet active_set;     ///< N + 1
    StickSlipPoint trailing;  ///< stick-slip point
    StickSlipPoint leading;   ///< stick-slip point of the mirrored contact

    void archive(Archive& archive, Eigen::Index size);
  };

  /// A step that goes through its substeps, or a derivative of the step. Each substep ends where an
  /// element has been travelled or with the step. For a given partition all is linear except for
  /// products of force and displacement.
  struct Step : RolledContact {
    RememberedState state;      ///< at the end of the substep
    SlipConditions conditions;  ///< of the substep
    double moved = 0;           ///< shift of the partition in the substep, including the lead  [mm]
    double creepage = 0;        ///< shift of the mean over partitions in the substep  [mm]
    double substep_force = 0;   ///< mean of the force over the substep  [N/mm]
    double substep_pressed = 0;  ///< work of the pressure per mm rolled in the substep  [N/mm]
    double entry = 0;            ///< traction of the element at the entry  [N/mm^2]

    // Summed over the substeps.
    double shift = 0;       ///< [mm]
    double mean_force = 0;  ///< [N]
    double work = 0;        ///< of the force  [N]
  };

  /// A substep with its load.
  struct Substep : SubstepEnd {
    double length;  ///< [mm]
    ShiftLoad load;
    std::array<ShiftLoad, 2> load_slopes;  ///< by load and length of the step
    bool is_last;
  };

  /// A step; if its length is 0, a shift without rolling.
  struct Way {
    double length;  ///< [mm]
    ShiftLoad load;
  };

  /// Returns the fraction of the first element that is in the contact. The contact begins where the
  /// scheme would feel the trailing edge without the first element.
  static double exit_share(const LeadingEdgeConstants& edge);

  void set_response(double half_width);
  void set_bound(const ContactScale& scale);
  RememberedState start_of(const Eigen::VectorXd& traction, const ContactScale& scale) const;
  void begin(const Eigen::VectorXd& traction, TransientState& state);
  void displace_ends(RememberedPoints& nodes, const Eigen::VectorXd& traction, double entry) const;
  Eigen::VectorXd displaced_by_entry(double entry) const;
  Eigen::VectorXd displaced_by(const Eigen::VectorXd& traction) const;
  void press_nodes(RememberedPoints& nodes) const;
  void press_ends(RememberedPoints& nodes) const;
  double work_of_pressure(const Eigen::VectorXd& traction) const;
  void give_tractions(const RememberedState& now, TransientState& state) const;
  StandingContact& standing();
  void shift_standing(const ShiftLoad& load);
  ShiftLoad of_standing_partition(const ShiftLoad& load) const;
  bool search_standing(const ShiftLoad& load, SlipConditions& conditions, ContactState& contact);
  void average_standing(const ShiftLoad& load, SlipConditions conditions, RolledContact rolled);
  void place_nodes();

  void begin_step(bool with_slopes);
  void roll(const Way& way);
  void roll_substep_to(const Way& way, double begin, double length, double end,
                       const NextSubstep& next);
  void begin_lost_contact();
  void change_contact(const Way& way);
  void roll_substep(const Substep& substep);
  void recall(Step& step, const Substep& substep) const;
  ShiftLoad of_partition(const ShiftLoad& load, const Step& step) const;
  bool nodes_carry(const ShiftLoad& load) const;
  void end_fading(const Substep& substep);
  void fade_shift(const Substep& substep);
  void settle_lead(const ShiftLoad& load);
  void search_partition(const ShiftLoad& load);
  void solve_slopes(const Substep& substep);
  void add_slip(const Substep& substep);
  void displace(Step& step) const;
  void finish_substep(Step& step, const Substep& substep, bool stuck_again) const;
  StepSlopes slopes_of_step(const Step& slope, const TransientState& after, double length,
                            double by_length) const;

  TractionBound traction_bound_;
  Eigen::VectorXd problem_nodes_;  ///< [mm]
  Eigen::VectorXd problem_x_;      ///< of the nodes on the problem's contact  [mm]
  double reach_;                   ///< largest distance of its elements from the centre  [mm]
  Eigen::VectorXd problem_bound_;  ///< its means over elements of the problem's contact  [N/mm^2]
  ReferenceNodes nodes_;
  LeadingEdgeConstants edge_;
  Kernel kernel_;
  bool has_layer_;  ///< whether displacements bend at the stick-slip point
  Solver solver_;
  double response_to_ = 1;   ///< half-width for which the response is made, over the problem's
  Eigen::VectorXd pressed_;  ///< displacement by the pressure, of bodies of different material, at
                             ///< nodes, entry and exit; else none  [mm]
  Eigen::VectorXd influence_;  ///< displacement by an element 0 ... N + 1 elements away  [mm^3/N]
  MeanSpring spring_;
  CompliantElement exit_;  ///< the first element
  StickSlipPoint stick_slip_point_;
  std::optional<StandingContact> standing_;  ///< from the first shift on

  RememberedState state_;
  Step next_;                   ///< the step that was solved last
  std::array<Step, 2> slopes_;  ///< derivatives of `next_` by its load and by its length
  bool has_slopes_ = false;
  ContactState sum_;  ///< the step's result; slip and shift  [mm]
};

}  // namespace microslip
