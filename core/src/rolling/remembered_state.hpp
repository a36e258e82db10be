// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "element_travel.hpp"
#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "remembered_points.hpp"

namespace microslip {

class Archive;

/// The nodes on the problem's contact. On another they keep their places over its half-width.
struct ReferenceNodes {
  Eigen::Index size = 0;  ///< N
  double spacing = 0;     ///< dx  [mm]
  double first = 0;       ///< x of the first node over dx

  /// Of the entry, one element ahead of the last node.
  double entry() const { return first + static_cast<double>(size); }
};

/// Where the nodes are when a part of a step ends.
struct PartEnd {
  double distance;      ///< rolled  [mm]
  ContactScale scale;   ///< of the contact
  NodeShift on_points;  ///< the nodes among the points that are remembered
  NodeShift on_nodes;   ///< and among the nodes when the part began
  bool is_whole;        ///< whether either end of the contact has travelled an element
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

  /// The end of a part that begins here.
  PartEnd end_of_part(const ReferenceNodes& nodes, double length, double end,
                      const ContactScale& scale) const;

  /// The displacement with which the material has come to a node.
  double remembered_at(Eigen::Index i, const PartEnd& end) const;

  /// Its derivative by the length of the part, where the contact does not change  [1]
  double slope_at_node(const ReferenceNodes& nodes, Eigen::Index i, const PartEnd& end) const;

  /// Remembers the displacements now as if all material came just now.
  void remember_all();

  /// Remembers the displacements at the end of a part.
  void remember(const ReferenceNodes& nodes, const PartEnd& end, bool stuck_again);

  /// Points next to the stick-slip point have slipped as they did: they stick again.
  void admit_slip(const ReferenceNodes& nodes);

  /// After a shift, the point that came to the entry last sticks if it is in the contact and its
  /// neighbours do.
  /// \param offset  of the leading edge from the last node  [dx]
  void admit_entry(const ReferenceNodes& nodes, double offset);

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

  Source source_of(Eigen::Index i, const PartEnd& end) const;
  NodeShift among_points(const ReferenceNodes& nodes) const;
  double between_nodes(Eigen::Index point, const NodeShift& shift) const;
  void renew_points(const PartEnd& end, Eigen::Index from);
};

/// A part of a step on a contact that changes.
struct NextPart {
  double end;     ///< as a fraction of the step
  bool is_whole;  ///< whether either end of the contact has travelled an element there
};

/// The part at the end of which either end of the contact has travelled an element of those by
/// which the state counts, forth or back; or the rest of the step.
/// \param fraction   of the step, where the part begins; the state is there
/// \param start      distance at which the step began  [mm]
/// \param length     of the step, >= 0  [mm]
/// \param from, to   the contact at its ends
NextPart next_part(const RememberedState& state, const ReferenceNodes& nodes, double fraction,
                   double start, double length, const ContactScale& from, const ContactScale& to);

}  // namespace microslip
