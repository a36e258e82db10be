// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "microslip/patch/joined_rows.hpp"
#include "microslip/patch/patch_response.hpp"
#include "slip_maps.hpp"

namespace microslip {

/// A step of a patch, in which the contact grows or shrinks linearly. Lengths are over the size of
/// the problem's patch.
struct PatchStep {
  double dq;         ///< that is rolled; 0 in a shift
  double from = 1;   ///< size of the contact before it, over the problem's
  double to = 1;     ///< at its end
  double ratio = 0;  ///< of the step before to this one, 0 without

  bool operator==(const PatchStep&) const = default;
};

/// The way of material in a step.
struct MaterialWay {
  double x;        ///< where it is at the end
  double length;   ///< that it rolled within the contact
  double entered;  ///< at this part of the step; 0 if before
};

/// Weights of the displacements at the leading edge at the end of a step, before it and a step
/// earlier, for that at the time between: a parabola, or a line without an earlier step.
struct EntryWeights {
  double now, before, earlier;

  /// \param entered  part of the step
  /// \param ratio    of the step before to this one; 0 without
  EntryWeights(double entered, double ratio) : now(entered), before(1 - entered), earlier(0) {
    if (ratio == 0) return;
    now = entered * (entered + ratio) / (1 + ratio);
    before = (1 - entered) * (entered + ratio) / ratio;
    earlier = -entered * (1 - entered) / (ratio * (1 + ratio));
  }
};

/// The ways of the material at the cells of a patch in a step, which may change the size of an
/// ellipse, and the slip by them.
class StepWays {
 public:
  using Index = Eigen::Index;

  StepWays(const JoinedRows& rows, const PatchStep& step);

  const JoinedRows& rows() const { return rows_; }
  const PatchStep& step() const { return step_; }

  /// The way to the centre of a cell at the end.
  MaterialWay to_centre(Index i, Index k) const { return way_to(x(2 * i + 1, k), k); }

  /// The way of the material that passes the centre in the middle of the step; or, in long steps,
  /// that is at the trailing side of the cell at the end. Material that a growing contact takes in
  /// there, later than at the centre, has no slip yet: it is that at the centre then.
  MaterialWay about_centre(Index i, Index k) const;

  /// The part that the slip seen from the contact has in that of cells: s = w - du/dx + du/dq at their
  /// centres at the end, with the change of the displacement in the step over its length. In short
  /// steps all is the slip of the material, of second order. On long ways the slip may turn, so that
  /// its mean is not that at the end.
  double part_in_contact() const { return part_in_contact_; }

  /// Whether the slip seen from the contact follows from the own slip of a cell and of the cell ahead:
  /// whether the material at both centres was in the contact before the step.
  bool is_seen(Index i, Index k) const {
    return i > 0 && to_centre(i - 1, k).entered == 0 && to_centre(i, k).entered == 0;
  }

  /// The part of a step in the slip that is seen: short steps change it by as much as they are of the way
  /// to the centre ahead.
  double part_seen(Index i, Index k) const {
    return std::min(1.0, step_.dq / distance_ahead(i, k));
  }

  /// From the centre of a cell to the centre ahead.
  double distance_ahead(Index i, Index k) const { return x(2 * i - 1, k) - x(2 * i + 1, k); }

  /// The length by which the change of the rigid slip from the step before to this one adds to the
  /// displacement at entry. What material remembers, its displacement and all rigid slip, is smooth
  /// where motions change, unlike the displacement alone: the parabola goes through that.
  double by_change_of_motion(const MaterialWay& way) const;

  /// The rigid slip at the leading edge of a row by the motion: 2 x 3.
  Eigen::Matrix<double, 2, 3> rigid_slip_at_edge(Index k) const;

  /// The slip of all cells in the step, and that at the centres, as a linear response.
  /// \param displacement  as displacement_by_traction()
  PatchResponse response(const PatchResponse::Matrix& displacement) const;

 private:
  double x(Index j, Index k) const { return step_.to * rows_.x(j, k); }
  MaterialWay way_to(double x, Index k) const;
  double entry(double x, Index k) const;
  void add_entry(PatchSlipMap& map, Index i, Index k, const MaterialWay& way) const;
  double part_at_pole(Index i, Index k) const;
  SeenSlip seen() const;
  PointSlip slip_about(const MaterialWay& way, Index k) const;
  void mix_slip_in_contact(PatchSlipMap& map, const PatchResponse::Matrix& displacement) const;
  double length(Index i, Index k) const { return x(2 * i, k) - x(2 * i + 2, k); }

  const JoinedRows& rows_;
  PatchStep step_;
  double part_in_contact_ = 0;
};

}  // namespace microslip
