// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/kernel.hpp"

namespace microslip {

/// How a strain that is a difference over one element feels the leading edge of the contact: two
/// constants of the Wiener-Hopf factors of its symbol, which is 2 (1 - nu)/G dx times
/// 2 |sin(theta/2)| V(theta) for the displacement of a whole element's tractions. The kernel's
/// logarithm alone determines them, so they hold for strips and plane strain.
///
/// With a Winkler layer in series tractions vanish linearly close to the edge, and like a square
/// root far from it. The symbol is then V + 2 softness |sin(theta/2)|; the exact kernel has 1 +
/// softness |theta|. The softness() is C/C_e; of springs alone, which is infinite, the edge is felt
/// where it is, one element beyond the last node.
struct LeadingEdgeConstants {
  /// delta: to second order, the tractions belong to a contact whose leading edge lies so many
  /// elements beyond the last node, whatever the offset of the grid  [1]
  double offset;

  /// C_0/C_e: the slip displacement of the next node while the edge passes over an element, over
  /// 2 (1 - nu)/G dx + C times the traction that the scheme gives it in adhesion at the end; C is
  /// the layer's compliance  [1]
  double compliance;

  /// The second node's traction over the first's  [1]
  double second;

  /// Tractions of the scheme at the last, last but one, ... node over the exact square root,
  /// sqrt(j + offset); 1 far from the edge. With a layer, in between 1, which springs alone have,
  /// and these, as the offset is  [1]
  std::array<double, 8> layer;

  /// The same after a fraction of the next element has been travelled: the mean of the solutions
  /// with and without its node, over sqrt(j + offset + fraction); j = -1 for that node.
  /// \param fraction  in [0, 1)
  /// \return          1 from j = 7 on
  double value(Eigen::Index j, double fraction) const;
};

/// The compliance C of a layer over the compliance of an element of the half-space, C_e = pi k dx;
/// infinite without a half-space.
/// \param spacing  dx  [mm]
double softness(const Kernel& kernel, double spacing);

/// offset = 3/4 - 1/(4 pi) int_0^pi ln V / sin^2(theta/2) dtheta,
/// compliance = exp(1/pi int_0^pi ln V dtheta),
/// V = 2 sin(theta/2) sum over all n of shape^(theta + 2 pi n) / |theta + 2 pi n|.
/// With a layer V + 2 softness sin(theta/2) takes the place of V, and to the offset
/// 1/pi int_0^inf ln(1 + softness theta) / theta^2 dtheta is added, which is the exact kernel's.
/// \param basis     constant or linear
/// \param softness  C/C_e, in [0, inf]
/// \throws std::invalid_argument for others
/// Accuracy: 1e-15 without a layer, tests/digits/spectrum_test.cpp; 1e-12 with one
LeadingEdgeConstants leading_edge_constants(const Basis& basis, double softness = 0);

}  // namespace microslip
