// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "row_edges.hpp"
#include "row_friction.hpp"
#include "row_response.hpp"
#include "row_step.hpp"
#include "step_tangent.hpp"
#include "stick_slip_point.hpp"
#include "substeps.hpp"

namespace microslip {

/// A row that rolls through substeps: s = S + A p - U, where U is the displacement that the
/// material would have without slip. StickSlipPoint gives the mean of the solutions of four
/// partitions, so that the stick-slip point moves evenly through the elements.
///
/// Cost: a solve of ActiveSet for each substep; a substep ends where an element has been travelled
/// or with the step. Where the partition changes, four neighbours of the stick-slip point are
/// solved, too. Nothing is allocated if the partitions have been met in earlier steps.
class RollingRow {
 public:
  explicit RollingRow(const TransientProblem& problem);

  const Grid& grid() const { return grid_; }
  const RowEdges& edges() const { return edges_; }
  RowResponse& response() { return response_; }
  const RowResponse& response() const { return response_; }

  /// The friction that depends on slip; none if it does not.
  std::optional<RowFriction>& friction() { return friction_; }

  /// Bound of the tractions that were solved last  [N/mm^2]
  const Eigen::VectorXd& bound() const { return step_.conditions.bound; }

  /// Takes the half-width of a contact.
  void set_half_width(double half_width);

  /// Takes the bound of a contact, for tractions on the problem's contact.
  void set_bound(const ContactScale& scale);

  /// Takes bound and pressure of the contact, or of the mirrored contact.
  void face(bool backward);

  /// Makes the memory of tractions on a contact that has not rolled yet; the bound that is set
  /// limits them.
  RowMemory started(const Eigen::VectorXd& traction, const ContactScale& scale) const;

  /// Makes the memory of bodies that turn round: the material in the contact remembers the
  /// displacements by the present tractions, and no more.
  /// \throws as ActiveSet::solve
  RowMemory turned(const RowMemory& from);

  /// Begins a step, or a shift.
  void begin(const RowMemory& from, bool with_slopes);

  /// Rolls all the way in substeps.
  /// \param from    where it begins
  /// \param target  the contact where it ends
  /// \throws as for_each_part, ActiveSet::solve
  void roll(const Way& way, const RowMemory& from, const ContactScale& target);

  /// Moves to the end of a way on which the contact is lost, or only begins.
  void replace(const Way& way, const RowMemory& from, const ContactScale& target);

  /// The step that was begun last, as far as it has gone.
  RowStep& step() { return step_; }
  const StepTangent& tangent() const { return tangent_; }

  /// Its result on the problem's contact; slip is summed over the substeps  [mm]
  ContactState& result() { return result_; }

  /// Writes or reads the responses that later steps use, but no step.
  void archive(Archive& archive);

 private:
  RowPoints displacements_of(const RowMemory& memory) const;
  void roll_substep(const Substep& substep);
  void settle_lead(const ShiftLoad& load);
  void search_partition(const Substep& substep);
  bool nodes_carry(const ShiftLoad& load) const;
  void fade_shift(const Substep& substep);
  void end_entry();
  void add_slip(const Substep& substep);

  RowEdges edges_;
  Grid grid_;
  RowResponse response_;
  std::optional<RowFriction> friction_;
  StickSlipPoint stick_slip_point_;
  RowStep step_;
  StepTangent tangent_;
  ContactState result_;
};

}  // namespace microslip
