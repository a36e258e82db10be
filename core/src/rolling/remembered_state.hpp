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
/// edge of a shift without that element. Without rolling, tractions in adhesion are singular at the
/// edge, and the scheme feels the edge half an element nearer. So an element at the entry carries
/// traction, on a spring that makes the solution the mean of the solutions with and without the
/// element.
inline constexpr double entry_share = 0.5;

/// The nodes on the problem's contact. On another contact, nodes keep their places over the
/// half-width.
struct ReferenceNodes {
  Eigen::Index size = 0;  ///< N
  double spacing = 0;     ///< dx  [mm]
  double first = 0;       ///< x of the first node over dx

  /// Returns the place of the entry, one element ahead of the last node, over dx.
  double entry() const { return first + static_cast<double>(size); }
};

/// The places of the nodes at the end of a substep.
struct SubstepEnd {
  double distance;      ///< rolled  [mm]
  ContactScale scale;   ///< of the contact
  NodeShift on_points;  ///< the nodes among the remembered points
  NodeShift on_nodes;   ///< the nodes among the nodes when the substep began
  bool is_whole;        ///< whether either end of the contact has travelled an element
};

/// The difference between the mean over partitions and the solution of one partition, for nodes and
/// entry.
struct MeanChange {
  Eigen::VectorXd traction;      ///< N + 1 or none  [N/mm^2]
  Eigen::VectorXd displacement;  ///< N + 1 or none  [mm]
  double shift = 0;              ///< [mm]

  MeanChange& operator+=(const MeanChange& other);
  void archive(Archive& archive, Eigen::Index size);
};

/// The memory of successive shifts without rolling. An element at the entry carries traction then,
/// and its spring adds slip. The displacements of points and nodes belong to the partitions that
/// meet the conditions.
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

  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);
};

/// The displacements that the material remembers, and the state from which a step starts.
///
/// The remembered displacement of a material point is its displacement by the tractions when it
/// came, minus the rigid shift since then: the displacement that the point has now if it has stuck.
///
/// Tractions are on the problem's contact and have the same forces: they are `scale.half_width`
/// times the tractions on the present contact.
struct RememberedState : ElementTravel {
  ContactScale scale;     ///< of the contact now
  double counted_by = 1;  ///< travel is counted in elements of this half-width, over the problem's

  /// Displacements of the material points that were at nodes, entry and exit when the last whole
  /// element had been travelled; points next to the stick-slip point count as not slipped.
  RememberedPoints points;
  RememberedPoints nodes;  ///< at nodes, entry and exit now

  Eigen::VectorXd traction;  ///< N, the mean over partitions  [N/mm^2]
  std::vector<Zone> zones;   ///< of the partition that meets the conditions
  Eigen::Index stuck = 0;    ///< the first node in adhesion; N if there is none
  double stored = 0;         ///< energy of the bodies  [N]
  Eigen::Index kept = 0;     ///< points from this index on count as not slipped
  double lead = 0;           ///< shift of the mean over partitions minus the shift by `zones`  [mm]

  std::optional<ShiftMemory> shifts;  ///< since the contact has stopped; none while it rolls

  // The last shift leaves these values. They fall evenly to 0 while an element is travelled.
  double entry = 0;  ///< traction of the element at the entry; `traction` gives it to the last node
                     ///< [N/mm^2]
  Eigen::VectorXd relief;  ///< by how much tractions that slip at the leading end are below the
                           ///< bound in the mean; N or none  [N/mm^2]
  double ahead = 0;  ///< slip in shifts since the last whole element, to be subtracted from the
                     ///< displacement of the next point that is remembered  [mm]

  /// Returns the end of a substep that begins at this state.
  SubstepEnd end_of_substep(const ReferenceNodes& nodes, double length, double end,
                            const ContactScale& scale) const;

  /// Returns the displacement with which the material has come to a node.
  double remembered_at(Eigen::Index i, const SubstepEnd& end) const;

  /// Returns the derivative of remembered_at() by the length of the substep, for a contact that
  /// does not change  [1]
  double slope_at_node(const ReferenceNodes& nodes, Eigen::Index i, const SubstepEnd& end) const;

  /// Remembers the displacements now as if all material came just now.
  void remember_all();

  /// Remembers the displacements at the end of a substep.
  void remember(const ReferenceNodes& nodes, const SubstepEnd& end, bool stuck_again);

  /// Lets points next to the stick-slip point slip as far as their nodes have slipped, because they
  /// stick again.
  void admit_slip(const ReferenceNodes& nodes);

  /// Begins shifts where the contact has rolled to.
  /// \param spring  compliance under the element at the entry  [mm^3/N]
  void begin_shifts(double spring);

  /// Turns: if a shift goes the other way than the shift before, all points stick first.
  /// \param toward  sign of the shift
  void go(const ReferenceNodes& nodes, double toward);

  /// Remembers the displacements after a shift.
  /// \param end     of a substep without length
  /// \param zones   of nodes and entry
  void remember_shift(const ReferenceNodes& nodes, const SubstepEnd& end,
                      const std::vector<Zone>& zones, bool stuck_again);

  /// Lets points next to the leading end of adhesion slip as far as their nodes have slipped,
  /// because they stick again.
  void admit_leading_slip(const ReferenceNodes& nodes);

  /// Ends the shifts: material at the leading end of adhesion has slipped as far as the mean over
  /// partitions says. The points at the entry are partly inside, partly outside.
  /// \param bound  of tractions in rolling, N values  [N/mm^2]
  void end_shifts(const ReferenceNodes& nodes, const Eigen::VectorXd& bound);

  /// Lets the point at the entry that came last slip as far as it has slipped.
  void admit_entry(const ReferenceNodes& nodes);

  /// Tells whether the point that came to the entry last is in the contact.
  /// \param offset  distance from the last node to the leading edge  [dx]
  bool entry_has_come(const ReferenceNodes& nodes, double offset) const;

  /// Returns the fraction of the traction at the entry, and of the relief, that is left at the end
  /// of a substep, and the derivative of this fraction by the length of the substep [1/mm].
  std::pair<double, double> left_of_shift(const ReferenceNodes& nodes, const SubstepEnd& end) const;

  /// Writes or reads all members.
  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);

 private:
  /// The values among which the displacement of a node is looked up.
  struct Source {
    const RememberedPoints& displacements;
    double shift;       ///< of the node among these displacements
    Eigen::Index from;  ///< only values from this index on are used
    double half_width;  ///< of the contact of these displacements, over the problem's
  };

  Source source_of(Eigen::Index i, const SubstepEnd& end) const;
  NodeShift among_points(const ReferenceNodes& nodes) const;
  void slip_points(const ReferenceNodes& nodes, Eigen::Index from, Eigen::Index to);
  void share_slip(const ReferenceNodes& nodes, double slip);
  void renew_points(const SubstepEnd& end, Eigen::Index from);
};

/// The next substep on a contact that changes.
struct NextSubstep {
  double end;     ///< as a fraction of the step
  bool is_whole;  ///< whether either end of the contact has travelled an element there
};

/// Finds the next substep. It ends where the leading or the trailing edge has travelled an element,
/// forth or back, or with the step. The length of the element is the one by which the state counts.
/// \param fraction   of the step, where the substep begins; the state is there
/// \param start      distance at which the step began  [mm]
/// \param length     of the step, >= 0  [mm]
/// \param from, to   the contact when the step begins and ends
NextSubstep next_substep(const RememberedState& state, const ReferenceNodes& nodes, double fraction,
                         double start, double length, const ContactScale& from,
                         const ContactScale& to);

}  // namespace microslip
