// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/friction/active_set.hpp"

namespace microslip {

class Archive;
struct RowMemory;
struct SubstepEnd;

/// The difference between the mean over partitions and the solution of one partition, for nodes and
/// entry.
struct MeanChange {
  Eigen::VectorXd traction;      ///< N + 1 or none  [N/mm^2]
  Eigen::VectorXd displacement;  ///< N + 1 or none  [mm]
  double shift = 0;              ///< [mm]

  MeanChange& operator+=(const MeanChange& other);

  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);
};

/// The memory of successive shifts without rolling, a part of the row's memory. An element at the
/// entry carries traction then, and its spring adds slip. The displacements of points and nodes
/// belong to the partitions that meet the conditions.
struct ShiftMemory {
  double toward = 0;           ///< sign of the last shift
  Eigen::VectorXd reversal;    ///< tractions of nodes and entry when shifts last turned;
                               ///< N + 1 or none  [N/mm^2]
  MeanChange leading_mean;     ///< of the last shift, at the leading end of adhesion
  MeanChange mean;             ///< of the last shift, at both ends of adhesion
  MeanChange before_turn;      ///< when shifts last turned; since then the mean adds twice as much
  double at_entry = 0;         ///< displacement that the element has now if it has stuck  [mm]
  double entry_displaced = 0;  ///< displacement of the element by the partition  [mm]
  double entry_slip = 0;       ///< of the material at the entry  [mm]
  Eigen::Index leading = 0;    ///< the node ahead of the last in adhesion
  Eigen::Index leading_kept = 0;  ///< points from `leading` to before this count as not slipped

  /// Tells whether a point counts as not slipped because it is next to the leading end of adhesion.
  bool keeps(Eigen::Index i) const { return i >= leading && i < leading_kept; }

  /// Begins shifts where a row has rolled to, unless they have begun.
  /// \param spring  compliance under the element at the entry  [mm^3/N]
  static void begin(RowMemory& memory, double spring);

  /// Turns: if a shift goes the other way than the shift before, all points stick first.
  /// \param sign  of the shift
  void go(RowMemory& memory, double sign);

  /// Remembers the displacements after a shift.
  /// \param end        of a substep without length
  /// \param with_entry  zones of nodes and entry
  void remember(RowMemory& memory, const SubstepEnd& end, const std::vector<Zone>& with_entry,
                bool stuck_again);

  /// Lets points next to the leading end of adhesion slip as far as their nodes have slipped,
  /// because they stick again.
  void admit_leading_slip(RowMemory& memory);

  /// Ends the shifts: material at the leading end of adhesion has slipped as far as the mean over
  /// partitions says. The points at the entry are partly inside, partly outside.
  /// \param bound  of tractions in rolling, N values  [N/mm^2]
  static void end(RowMemory& memory, const Eigen::VectorXd& bound);

  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);
};

}  // namespace microslip
