// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/friction/active_set.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "stick_slip_point.hpp"

namespace microslip {

/// Where a row of constant elements feels the edges of the contact.
///
/// - The leading edge lies LeadingEdgeConstants::offset elements ahead of the last node.
/// - Nodes are 2 a/N apart, so that a step of one element is not divided. The first node would
///   then feel the trailing edge 0.15 elements behind the contact's edge. So the first element is
///   on a spring, which makes the solution the mean of the solutions with and without it.
/// - In a shift without rolling, tractions in adhesion are singular at the leading edge, and the
///   scheme feels the edge half an element nearer. So an element at the entry, one element ahead
///   of the last node, carries traction, too, on a spring likewise.
class RowEdges {
 public:
  /// The fraction of the element at the entry that is in the contact, from where the scheme feels
  /// the edge of a shift without that element.
  static constexpr double entry_share = 0.5;

  /// \param spacing  dx  [mm]
  RowEdges(const Kernel& kernel, double spacing);

  const LeadingEdgeConstants& constants() const { return constants_; }

  /// The row's nodes over a contact.
  /// \param elements    N
  Grid nodes(double half_width, Eigen::Index elements) const;

  /// The first element.
  CompliantElement exit() const { return {0, spring(exit_share())}; }

  /// The element at the entry.
  /// \param size  N
  CompliantElement entry(Eigen::Index size) const { return {size, spring(entry_share)}; }

  /// The stick-slip point at the trailing end of adhesion, or the leading end of the mirrored row.
  StickSlipPoint trailing_point() const { return {constants_, exit_share()}; }
  StickSlipPoint leading_point() const { return {constants_, entry_share}; }

 private:
  /// The fraction of the first element that is in the contact. The contact begins where the scheme
  /// would feel the trailing edge without the first element.
  double exit_share() const { return 2.5 - 2 * constants_.offset; }

  /// Returns the compliance with which the solution is the mean of the solutions with and without
  /// an element.
  /// \param share  of the solution with the element, in (0, 1)
  double spring(double share) const { return compliance_ * (1 - share) / share; }

  LeadingEdgeConstants constants_;
  double compliance_;  ///< of an element at an edge  [mm^3/N]
};

}  // namespace microslip
