// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "material_records.hpp"
#include "microslip/patch/joined_rows.hpp"
#include "microslip/patch/patch_response.hpp"
#include "microslip/support/archive.hpp"
#include "point_displacements.hpp"
#include "step_ways.hpp"

namespace microslip {

/// All that the material of a patch remembers of its displacement and of all rigid slip, row by row.
/// Lengths are over the size of the problem's patch.
class PatchMaterial {
 public:
  using Index = Eigen::Index;
  using Vector2d = Eigen::Vector2d;

  /// Remembers nothing: no displacement, no slip.
  /// \param size      of the contact; 0 of bodies that do not touch
  /// \param distance  rolled so far
  PatchMaterial(const JoinedRows& rows, double size, double distance = 0);

  double distance() const { return distance_; }  ///< rolled so far, since the beginning
  double size() const { return size_; }          ///< of the contact now

  /// The length of the last step over that of the next one; 0 where these differ too much for the
  /// one to tell of the other, and after a shift.
  double ratio_before(double dq) const;

  /// The same material, by rows that lie where those of a contact of another size do. Rows outside
  /// the present contact remember what the outermost ones do, until they touch; where the bodies do
  /// not touch, nothing.
  PatchMaterial resized(const JoinedRows& rows, double size) const;

  /// The part of the slip in a step that comes from what was before it.
  /// \param step   to the present size
  /// \param u      displacements before it
  /// \param found  out
  void impose(const PatchStep& step, PointDisplacements& u, const Eigen::VectorXd& seen_before,
              ImposedSlip& found) const;

  /// Remembers displacements that no slip has led to, before the first step.
  void begin(PointDisplacements& u);

  /// Takes over a step.
  /// \param step    to the present size
  /// \param u       displacements at its end
  /// \param motion  as a mean over the step, or that of the shift
  /// \param slips   cells that slip, which remember where they are now
  void take(const PatchStep& step, PointDisplacements& u, const Eigen::Vector3d& motion,
            const std::vector<bool>& slips);

  void archive(Archive& archive);

 private:
  Vector2d remembered(const JoinedRows& rows, double x, Index k, double dq) const;
  Vector2d imposed_by(const StepWays& ways, const MaterialWay& way, Index k) const;
  static Vector2d seen_from_contact(const StepWays& ways, Index i, Index k, PointDisplacements& u,
                                    const Eigen::VectorXd& own);
  MaterialRecords moved_row(const JoinedRows& rows, Index k, double size) const;
  void record_entered(Index k, PointDisplacements& u, double dq);
  void replace_where_slips(Index k, PointDisplacements& u, const std::vector<bool>& slips);
  bool is_mostly_new(const JoinedRows& rows, Index k, const PatchStep& step) const;
  void touch_anew(Index k, PointDisplacements& u);
  void renew_origin(const JoinedRows& rows);

  std::vector<MaterialRecords> memory_;
  RigidPath path_;
  /// Rolled since the beginning, and since the origin of places and of the path, which follows the
  /// contact: so that short steps after a long way keep their digits.
  double distance_ = 0, travelled_ = 0;
  double size_;
  Eigen::Vector3d motion_ = Eigen::Vector3d::Zero();  ///< of the last step
  double step_before_ = 0;  ///< its length; 0 if there was none, or a shift
  /// Displacements at the leading edges, along and across, before the last step and after it.
  Eigen::MatrixX2d edge_before_, edge_;
};

}  // namespace microslip
