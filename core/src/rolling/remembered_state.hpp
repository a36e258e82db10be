// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "element_travel.hpp"
#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "remembered_points.hpp"

namespace microslip {

class Archive;

/// The fraction of an element at the entry that is in the contact, from where the scheme feels the
/// edge of a shift without that element. Without rolling, tractions in adhesion are singular there, and the edge
/// is felt half an element nearer. So an element at the entry carries traction, on a spring that is
/// the mean of the solutions with and without it.
inline constexpr double entry_share = 0.5;

/// The nodes on the problem's contact. On another they keep their places over its half-width.
struct ReferenceNodes {
  Eigen::Index size = 0;  ///< N
  double spacing = 0;     ///< dx  [mm]
  double first = 0;       ///< x of the first node over dx

  /// Of the entry, one element ahead of the last node.
  double entry() const { return first + static_cast<double>(size); }
};

/// Where the nodes are when a substep ends.
struct SubstepEnd {
  double distance;      ///< rolled  [mm]
  ContactScale scale;   ///< of the contact
  NodeShift on_points;  ///< the nodes among the points that are remembered
  NodeShift on_nodes;   ///< and among the nodes when the substep began
  bool is_whole;        ///< whether either end of the contact has travelled an element
};

/// What the mean over partitions adds to the solution of one, of nodes and entry.
struct MeanChange {
  Eigen::VectorXd traction;      ///< N + 1 or none  [N/mm^2]
  Eigen::VectorXd displacement;  ///< N + 1 or none  [mm]
  double shift = 0;              ///< [mm]

  MeanChange& operator+=(const MeanChange& other);
  void archive(Archive& archive, Eigen::Index size);
};

/// Of shifts without rolling, one after the other, in which an element at the entry carries
/// traction; its slip is that of a spring besides. Displacements of points and nodes are then those
/// by the partitions that meet the conditions.
struct ShiftMemory {
  double toward = 0;         ///< of the sign of the last shift
  Eigen::VectorXd reversal;  ///< tractions of nodes and entry since which shifts have gone one way;
                             ///< N + 1 or none  [N/mm^2]
  MeanChange leading_mean;   ///< of the last shift, at the leading end of adhesion
  MeanChange mean;           ///< at both ends
  MeanChange before_turn;    ///< when shifts last turned; since then the mean adds twice as much
  double at_entry = 0;       ///< displacement that the element has now if it has stuck  [mm]
  double entry_displaced = 0;     ///< and that it has by the partition  [mm]
  double entry_slip = 0;          ///< of the material at the entry  [mm]
  Eigen::Index leading = 0;       ///< the node ahead of the last in adhesion
  Eigen::Index leading_kept = 0;  ///< points from `leading` to here are as if they had not slipped

  /// Whether a point is as if it had not slipped, as it is next to the leading end of adhesion.
  bool keeps(Eigen::Index i) const { return i >= leading && i < leading_kept; }

  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);
};

/// The displacements that the material remembers, and the state from which a step starts.
///
/// A displacement is that of a material point by the tractions when it came, less the rigid shift
/// since: the displacement that it has now if it has stuck.
///
/// Tractions are those on the problem's contact that have the same forces: `scale.half_width` times
/// those of the contact.
struct RememberedState : ElementTravel {
  ContactScale scale;     ///< of the contact now
  double counted_by = 1;  ///< half-width, over the problem's, by whose elements travel is counted

  /// At the points of the material that were at nodes, entry and exit when the last whole element
  /// had been travelled, as if points next to the stick-slip point had not slipped.
  RememberedPoints points;
  RememberedPoints nodes;  ///< at nodes, entry and exit now

  Eigen::VectorXd traction;  ///< N, the mean over partitions  [N/mm^2]
  std::vector<Zone> zones;   ///< of the partition that meets the conditions
  Eigen::Index stuck = 0;    ///< the first node in adhesion; N if there is none
  double stored = 0;         ///< energy of the bodies  [N]
  Eigen::Index kept = 0;     ///< points from here on are as if they had not slipped
  double lead = 0;           ///< shift of the mean over partitions before that of `zones`  [mm]

  std::optional<ShiftMemory> shifts;  ///< since the contact has stopped; none while it rolls

  // What the last of them leaves. It falls evenly to 0 while an element is travelled.
  double entry = 0;  ///< traction of the element at the entry; `traction` gives it to the last node
                     ///< [N/mm^2]
  Eigen::VectorXd relief;  ///< by how much tractions that slip at the leading end are below the
                           ///< bound in the mean; N or none  [N/mm^2]
  double ahead = 0;  ///< what shifts since the last whole element have taken from the slip that
                     ///< the next point to be remembered shows  [mm]

  /// The end of a substep that begins here.
  SubstepEnd end_of_substep(const ReferenceNodes& nodes, double length, double end,
                            const ContactScale& scale) const;

  /// The displacement with which the material has come to a node.
  double remembered_at(Eigen::Index i, const SubstepEnd& end) const;

  /// Its derivative by the length of the substep, where the contact does not change  [1]
  double slope_at_node(const ReferenceNodes& nodes, Eigen::Index i, const SubstepEnd& end) const;

  /// Remembers the displacements now as if all material came just now.
  void remember_all();

  /// Remembers the displacements at the end of a substep.
  void remember(const ReferenceNodes& nodes, const SubstepEnd& end, bool stuck_again);

  /// Points next to the stick-slip point have slipped as they did: they stick again.
  void admit_slip(const ReferenceNodes& nodes);

  /// Shifts begin where the contact has rolled to.
  /// \param spring  of the element at the entry  [mm^3/N]
  void begin_shifts(double spring);

  /// If a shift goes the other way than the one before, all points stick first.
  /// \param toward  of its sign
  void go(const ReferenceNodes& nodes, double toward);

  /// Remembers the displacements after a shift.
  /// \param end     of a substep without length
  /// \param zones   of nodes and entry
  void remember_shift(const ReferenceNodes& nodes, const SubstepEnd& end,
                      const std::vector<Zone>& zones, bool stuck_again);

  /// Points next to the leading end of adhesion have slipped as they did: they stick again.
  void admit_leading_slip(const ReferenceNodes& nodes);

  /// Shifts are over: material at the leading end of adhesion has slipped as the mean over
  /// partitions has it. The points at the entry are between inside and outside.
  /// \param bound  N, that tractions keep in rolling  [N/mm^2]
  void end_shifts(const ReferenceNodes& nodes, const Eigen::VectorXd& bound);

  /// The point that came to the entry last has slipped as it did.
  void admit_entry(const ReferenceNodes& nodes);

  /// Whether that point is in the contact.
  /// \param offset  of the leading edge from the last node  [dx]
  bool entry_has_come(const ReferenceNodes& nodes, double offset) const;

  /// The fraction of the traction at the entry, and of the relief, that is left at the end of a
  /// substep, and its derivative by the length of the substep [1/mm].
  std::pair<double, double> left_of_shift(const ReferenceNodes& nodes, const SubstepEnd& end) const;

  /// Writes or reads all members.
  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);

 private:
  /// Where the displacement of a node is looked up.
  struct Source {
    const RememberedPoints& displacements;
    double shift;       ///< of the node among them
    Eigen::Index from;  ///< the values used have this index at least
    double half_width;  ///< over the problem's, of their contact
  };

  Source source_of(Eigen::Index i, const SubstepEnd& end) const;
  NodeShift among_points(const ReferenceNodes& nodes) const;
  void slip_points(const ReferenceNodes& nodes, Eigen::Index from, Eigen::Index to);
  void share_slip(const ReferenceNodes& nodes, double slip);
  void renew_points(const SubstepEnd& end, Eigen::Index from);
};

/// A substep on a contact that changes.
struct NextSubstep {
  double end;     ///< as a fraction of the step
  bool is_whole;  ///< whether either end of the contact has travelled an element there
};

/// The substep at the end of which either end of the contact has travelled an element of those by
/// which the state counts, forth or back; or the rest of the step.
/// \param fraction   of the step, where the substep begins; the state is there
/// \param start      distance at which the step began  [mm]
/// \param length     of the step, >= 0  [mm]
/// \param from, to   the contact at its ends
NextSubstep next_substep(const RememberedState& state, const ReferenceNodes& nodes, double fraction,
                         double start, double length, const ContactScale& from,
                         const ContactScale& to);

}  // namespace microslip
