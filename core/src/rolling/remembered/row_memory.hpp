// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "element_travel.hpp"
#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/contact_scale.hpp"
#include "row_points.hpp"
#include "shift_memory.hpp"

namespace microslip {

class Archive;

/// Interpolates present values to a remembered point, linearly between the nodes on either side.
/// \param values  at the nodes; constant behind the first and ahead of the last
/// \param shift   of the nodes among the points
double between_nodes(const Eigen::VectorXd& values, Eigen::Index point, const NodeShift& shift);

/// mu/mu_s of the material, where it depends on slip; otherwise empty.
struct RememberedFriction {
  Eigen::VectorXd points;  ///< N + 1, at the remembered points and at the entry
  Eigen::VectorXd nodes;   ///< N, at the nodes now

  /// Writes or reads the ratios of N nodes.
  void archive(Archive& archive, Eigen::Index size);
};

/// Points that slipped at most so many elements behind the stick-slip point are kept as if they had
/// not slipped, because the averaged partitions include their nodes in adhesion.
inline constexpr Eigen::Index kept_behind = 3;

/// The places of the nodes at the end of a substep.
struct SubstepEnd {
  double distance;      ///< rolled  [mm]
  ContactScale scale;   ///< of the contact
  NodeShift on_points;  ///< the nodes among the remembered points
  NodeShift on_nodes;   ///< the nodes among the nodes when the substep began
  bool is_whole;        ///< whether either end of the contact has travelled an element
};

/// The displacements that the material of a row remembers, and the state from which a step starts.
///
/// The remembered displacement of a material point is its displacement by the tractions when it
/// came, minus the rigid shift since then: the displacement that the point has now if it has stuck.
/// It is cubic between points one element apart. A point is remembered where it enters, one element
/// ahead of the last node, once for each element. Steps in between record no adhesion, so that
/// results do not depend on the step.
///
/// Tractions are on the problem's contact and have the same forces: they are `scale.half_width`
/// times the tractions on the present contact.
struct RowMemory : ElementTravel {
  explicit RowMemory(const RowNodes& row_nodes) : row(row_nodes) {}

  RowNodes row;
  bool backward = false;  ///< whether the row is the mirrored one, which rolls backward
  ContactScale scale;     ///< of the contact now
  double counted_by = 1;  ///< travel is counted in elements of this half-width, over the problem's

  /// Displacements of the material points that were at nodes, entry and exit when the last whole
  /// element had been travelled; points next to the stick-slip point count as not slipped.
  RowPoints points;
  RowPoints nodes;  ///< at nodes, entry and exit now

  Eigen::VectorXd traction;  ///< N, the mean over partitions  [N/mm^2]
  std::vector<Zone> zones;   ///< of the partition that meets the conditions
  Eigen::Index stuck = 0;    ///< the first node in adhesion; N if there is none
  double stored = 0;         ///< energy of the bodies  [N]
  Eigen::Index kept = 0;     ///< points from this index on count as not slipped
  double lead = 0;           ///< shift of the mean over partitions minus the shift by `zones`  [mm]

  RememberedFriction friction;

  std::optional<ShiftMemory> shifts;  ///< since the contact has stopped; none while it rolls

  // The last shift leaves these values. They fall evenly to 0 while an element is travelled.
  double entry = 0;  ///< traction of the element at the entry; `traction` gives it to the last node
                     ///< [N/mm^2]
  Eigen::VectorXd relief;  ///< by how much tractions that slip at the leading end are below the
                           ///< bound in the mean; N or none  [N/mm^2]
  double ahead = 0;  ///< slip in shifts since the last whole element, to be subtracted from the
                     ///< displacement of the next point that is remembered  [mm]

  /// Returns the end of a substep that begins here.
  SubstepEnd end_of_substep(double length, double end, const ContactScale& scale_at_end) const;

  /// Returns the end of a substep without length.
  SubstepEnd here() const { return end_of_substep(0, distance, scale); }

  /// Returns where the nodes are among the remembered points.
  NodeShift among_points() const;

  /// Returns the displacement with which the material has come to a node.
  double remembered_at(Eigen::Index i, const SubstepEnd& end) const;

  /// Returns the derivative of remembered_at() by the length of the substep, for a contact that
  /// does not change  [1]
  double slope_at_node(Eigen::Index i, const SubstepEnd& end) const;

  /// Returns the limit below which slip and shifts are rounding of the displacements  [mm]
  double rounding() const { return 1e-13 * nodes.at.cwiseAbs().maxCoeff(); }

  /// Remembers the displacements now as if all material came just now.
  void remember_all();

  /// Remembers the displacements at the end of a substep.
  void remember(const SubstepEnd& end, bool stuck_again);

  /// Lets points next to the stick-slip point slip as far as their nodes have slipped, because they
  /// stick again.
  void admit_slip();

  /// Lets the points of the given indices slip with the nodes.
  void slip_points(Eigen::Index from, Eigen::Index to);

  /// Lets the point at the entry that came last slip as far as it has slipped.
  void admit_entry();

  /// Tells whether the point that came to the entry last is in the contact.
  /// \param offset  distance from the last node to the leading edge  [dx]
  bool entry_has_come(double offset) const;

  /// Returns the fraction of the traction at the entry, and of the relief, that is left at the end
  /// of a substep, and the derivative of this fraction by the length of the substep [1/mm].
  std::pair<double, double> left_of_shift(const SubstepEnd& end) const;

  /// Writes or reads all members but `row` and `friction`.
  void archive(Archive& archive);

 private:
  /// The values among which the displacement of a node is looked up.
  struct Source {
    const RowPoints& displacements;
    double shift;       ///< of the node among these displacements
    Eigen::Index from;  ///< only values from this index on are used
    double half_width;  ///< of the contact of these displacements, over the problem's
  };

  Source source_of(Eigen::Index i, const SubstepEnd& end) const;
  void renew_points(const SubstepEnd& end, Eigen::Index from);
};

}  // namespace microslip
