// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "microslip/halfspace/basis.hpp"

namespace microslip {

/// How a strain that is a difference over one element feels the leading edge of the contact: two
/// constants of the Wiener-Hopf factors of its symbol, which is 2 (1 - nu)/G dx times
/// 2 |sin(theta/2)| b(theta) for the displacement of a whole element's tractions. The kernel's
/// logarithm alone determines them, so they hold for strips and plane strain.
struct LeadingEdgeConstants {
  /// beta*: whatever edge was meant, the tractions are those of a contact whose edge lies so many
  /// elements beyond the last node, to second order  [1]
  double offset;

  /// e0: how far the next node slips while the edge passes over an element, over 2 (1 - nu)/G dx
  /// times the traction that the scheme gives it in adhesion at the end  [1]
  double compliance;

  /// What the scheme gives to the last, last but one, ... node when the traction grows as a square
  /// root from the edge, over sqrt(j + offset); 1 far from it  [1]
  std::array<double, 8> layer;

  /// The same where a part of the next element has been travelled, in [0, 1): the mean of the
  /// solutions with and without its node, over sqrt(j + offset + part); j = -1 for that node.
  /// \return 1 from j = 7 on
  double value(Eigen::Index j, double part) const;
};

/// offset = 3/4 - 1/(4 pi) int_0^pi ln b / sin^2(theta/2) dtheta,
/// compliance = exp(1/pi int_0^pi ln b dtheta),
/// b = 2 sin(theta/2) sum over all m of shape^(theta + 2 pi m) / |theta + 2 pi m|.
/// \param basis  constant or linear
/// \throws std::invalid_argument for others
/// Accuracy: 1e-15, tests/digits/spectrum_test.cpp
LeadingEdgeConstants leading_edge_constants(const Basis& basis);

}  // namespace microslip
