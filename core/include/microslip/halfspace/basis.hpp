// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/halfspace/shape_function.hpp"

namespace microslip {

/// Shape functions of the nodes of a uniform grid. The traction is the sum of
/// coefficient times shape function.
class Basis {
 public:
  enum class Pattern {
    uniform,      ///< the first shape everywhere
    alternating,  ///< the first and second shape in turn, from the trailing edge
    last_differs  ///< the first shape, except for the second one at the last node, next to the
                  ///< leading edge
  };

  /// \param shapes  one shape; for the last two patterns, two
  /// \throws std::invalid_argument for another number of shapes
  Basis(std::string name, Pattern pattern, std::vector<ShapeFunction> shapes);

  const std::string& name() const { return name_; }
  Pattern pattern() const { return pattern_; }
  const std::vector<ShapeFunction>& shapes() const { return shapes_; }

  /// Whether all nodes have this function.
  bool has_only(const ShapeFunction& shape) const;

  /// Index into shapes() of node i of n, 0 <= i < n.
  std::size_t shape_of(Eigen::Index i, Eigen::Index n) const;

  /// Integrals of the n functions  [mm]
  Eigen::VectorXd weights(double spacing, Eigen::Index n) const;

 private:
  std::string name_;
  Pattern pattern_;
  std::vector<ShapeFunction> shapes_;
};

Basis constant_basis();
Basis linear_basis();

/// Continuous and piecewise quadratic functions on elements of two spacings. Nodes carry in turn
/// the bubble of an element and the Lagrange function of the vertex between two elements: thesis
/// (B.4), (B.5), with one spacing for both. The first node carries a bubble; with an odd number of
/// nodes and both offsets 1, elements fill the contact.
Basis quadratic_basis();

/// The quadratic basis with the influence coefficients as printed in thesis (B.30): the vertex
/// functions end at half their support.
Basis quadratic_basis_as_printed();

/// Hat functions; the last one is zero beyond the leading edge: thesis Fig. 10.2.
/// \param leading_offset  distance of the edge from the last node in elements, in (0, 1]
Basis trimmed_linear_basis(double leading_offset);

/// Constant functions; the last element also has the antisymmetric function of thesis (C.1). The
/// thesis gives no equation for its coefficient. Here the traction vanishes at the leading edge, so
/// that both functions of the last element form one that falls linearly to zero (for an offset of
/// 1/2).
Basis edge_constant_basis();

/// Names of the bases for scenes, the default first.
std::vector<std::string_view> basis_names();

/// \throws std::invalid_argument for another name
Basis make_basis(std::string_view name);

}  // namespace microslip
