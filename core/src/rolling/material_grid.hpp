// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "element_travel.hpp"
#include "microslip/friction/active_set.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/rolling/material_window.hpp"
#include "microslip/spectrum/leading_edge.hpp"
#include "rolling_grid.hpp"

namespace microslip {

/// History of the slip displacement of the incoming node, and of the node ahead of it. Both begin
/// when a node enters; when the incoming node enters, the one ahead takes its place. A shift takes
/// no part in it: the nodes start from where it leaves them.
class IncomingNode {
 public:
  /// Adds the slip of a step.
  /// \param phase  at the end of the step, up to 1; 1 in the last step before enter()
  void advance(double phase, double coming_slip, double ahead_slip);

  /// The node has entered; the one ahead of it is the next to come.
  void enter();

  /// Slip displacement of the incoming node since one element's travel before a phase, linear
  /// between the ends of steps  [mm]
  double since_one_element_before(double phase) const;

 private:
  struct Point {
    double phase;
    double slip;
  };

  std::vector<Point> before_;  ///< of the incoming node, over the element's travel before
  std::vector<Point> ahead_;   ///< of the node ahead, since then
  double coming_ = 0;          ///< slip of the incoming node since before_ starts  [mm]
};

/// The state from which a step on such a grid starts.
struct MaterialState : ElementTravel {
  /// At the nodes of the window; zones are slip where there is no bound. Slip and creepage are
  /// displacements [mm], summed over the substeps of the step that led here, and so are the
  /// partitions tried; the residuals are the worst. The slip of the coming node is 0 in adhesion.
  ContactState contact;

  IncomingNode incoming;

  /// Whether the node that leaves was in adhesion when it began to leave, or after a shift.
  bool leaves_by_spring = false;

  /// Of the bound of the node ahead and of the spring that holds it since a shift, until the coming
  /// node has entered; else 0.
  double ahead_share = 0;
};

/// The result of a step on such a grid.
struct MaterialStep {
  MaterialState end;
  Eigen::VectorXd bound;       ///< at its end  [N/mm^2]
  double dissipation = 0;      ///< with mean tractions of each substep, slip by A  [N]
  double end_dissipation = 0;  ///< with tractions at the end of each substep  [N]
  double mean_force = 0;       ///< over the distance, linear in each substep  [N/mm]
  double backward = 0;         ///< energy gained where slip has the traction's direction  [N]
};

/// Nodes that move with the material, constant functions: S = W + A (p - p') needs no
/// interpolation.
///
/// - The leading edge is where the scheme feels it. A step that passes by a node there is split, so
///   that the scheme behaves as with c = 1 however short the steps are.
/// - Between entries, the coming node carries traction through a spring of compliance
///   C t/(1 - t), where t is the fraction of its element that is still outside, and C = e0 2 (1 -
///   nu)/G dx. In adhesion its slip is that of the last element travelled. To first order this is
///   the mean of the solutions with and without it: the edge moves along evenly.
/// - A node that sticks when it begins to leave does so through the same spring, where t is the
///   fraction of its element that has left: the trailing edge moves along evenly, too. A shift
///   without rolling ends at both edges alike.
/// - Bounds are means over elements. Where the bound is not reached it has no influence.
///
/// Cost: a solve of ActiveSet a substep. Nothing is allocated where elements that come or leave
/// have done so before, as in steady rolling. Accuracy: the cumulative creep is of second order at
/// any load, tests/order/transient_order_test.cpp. The creepage of steps that are shorter than an
/// element has noise from elements that begin to slip. Where all substeps have the same partition,
/// tractions depend on the steps by rounding only, tests/unit/material_rolling_test.cpp
class MaterialGrid final : public RollingGrid {
 public:
  /// \throws std::invalid_argument as MaterialWindow
  explicit MaterialGrid(const TransientProblem& problem);

  std::unique_ptr<RollingGrid> clone() const override;
  Eigen::VectorXd traction_at_nodes(const TransientState& state) const override;
  void start_from(const Eigen::VectorXd& traction, TransientState& state) override;
  Shift solve_shift(const TransientState& before, const Load& load, TransientState& after) override;
  void solve_step(const TransientState& before, double length, const Load& load,
                  TransientState& after, StepJacobian* jacobian) override;
  void accept_step() override;
  void move_to(double distance) override;

 private:
  MaterialGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge);
  MaterialGrid(const TransientProblem& problem, const LeadingEdgeConstants& edge,
               const MaterialWindow& window);

  /// Of a step, between two entrances of nodes.
  struct Substep {
    double before;       ///< phase  [dx]
    double now;          ///< likewise, at its end
    Eigen::Index moved;  ///< 1 if a node enters at its end, else 0
    Eigen::Index edge;   ///< the node that enters or comes
    bool edge_is_new;    ///< so that its condition is about the last element travelled
  };

  double spring_compliance(double inside) const;
  MaterialState at_rest(const Eigen::VectorXd& traction) const;
  void begin(MaterialState start, TransientState& state);
  void roll(double length, const Load& load);
  void roll_substep(double length, double end, const Load& load);
  void set_first_zones(const MaterialState& from, const Substep& substep);
  void set_conditions(MaterialState& state, const Substep& substep);

  /// The edges that a shift holds by springs.
  struct HeldEdges {
    bool leading;
    bool trailing;
  };
  void set_shift_conditions(double phase, const HeldEdges& held);

  TractionBound traction_bound_;
  Eigen::VectorXd problem_nodes_;  ///< [mm]
  MaterialWindow window_;
  LeadingEdgeConstants edge_;
  double compliance_;  ///< e0 2 (1 - nu)/G dx  [mm^3/N]
  MaterialState state_;
  MaterialStep step_;  ///< that was solved last

  // Of the substep that is being rolled.
  SlipConditions conditions_;
  ContactState contact_;
};

}  // namespace microslip
