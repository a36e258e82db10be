// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "row_memory.hpp"
#include "row_response.hpp"
#include "stick_slip_point.hpp"
#include "substeps.hpp"

namespace microslip {

/// A row that goes through the substeps of a step, or a derivative of it. For a given partition all
/// is linear but for products of force and displacement; so one set of functions serves both.
struct RowStep : RolledContact {
  /// \param imposed  displacement by the pressure at nodes, entry and exit, N + 2; 0 in a
  ///                 derivative  [mm]
  RowStep(const RowResponse& response, Eigen::VectorXd imposed);

  RowMemory memory;           ///< at the end of the substep
  SlipConditions conditions;  ///< of the substep
  Eigen::VectorXd imposed;    ///< [mm]
  double moved = 0;           ///< shift of the partition in the substep, including the lead  [mm]
  double creepage = 0;        ///< shift of the mean over partitions in the substep  [mm]
  double force = 0;           ///< mean of the force over the substep  [N/mm]
  double pressed = 0;         ///< work of the pressure per mm rolled in the substep  [N/mm]
  double entry = 0;           ///< traction of the element at the entry  [N/mm^2]

  // Summed over the substeps.
  double shift = 0;       ///< [mm]
  double mean_force = 0;  ///< [N]
  double work = 0;        ///< of the force  [N]

  /// Begins a step.
  void begin(const RowMemory& from);

  /// Looks up the displacements U with which the material has come to the nodes. The slip is
  ///   s = S + A p + offset,  offset = - U + displacement by the element at the entry + imposed.
  void recall(const RowResponse& response, const SubstepEnd& end);

  /// The load of the partition: a shift makes up for the lead, a force is without the element at
  /// the entry.
  ShiftLoad of_partition(const ShiftLoad& load) const;

  /// Computes the displacements by the partition's solution, A p = s - S - offset, and moves the
  /// material by its shift.
  void displace(const RowResponse& response);

  /// Moves to the end of a substep, with the mean over partitions.
  void finish(const RowResponse& response, const SubstepEnd& end, bool stuck_again);
};

}  // namespace microslip
