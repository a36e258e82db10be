// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"

namespace microslip {

/// Nodes that are fixed to the material, of which only those near the contact are kept. A node
/// enters the contact when the leading edge has passed it by the offset that the scheme feels, see
/// LeadingEdgeConstants; the window then is aligned, and moves on by one node.
///
/// From the trailing edge on it holds one node behind the contact, because the displacement before
/// a step still feels a traction that has just left, N nodes in contact, the node that comes next,
/// and the one after that. A node leaves while it goes from half an element less than the leading
/// offset before the trailing edge to an element further on: where it sticks, that is where the
/// scheme feels the edge.
///
/// Everything is a function of the phase: distance rolled since it was last aligned, in [0, 1) [dx]
class MaterialWindow {
 public:
  /// A phase this close to 0 or 1 is there: distances are sums.
  static constexpr double rounding = 1e-9;

  /// \param grid            with offsets 1/2
  /// \param leading_offset  of the nodes from the leading edge when aligned, > 1/2  [dx]
  /// \throws std::invalid_argument for other offsets of the grid, and for one element
  MaterialWindow(const TractionBound& bound, const Grid& grid, double leading_offset);

  Eigen::Index size() const { return elements_ + 3; }
  double spacing() const { return spacing_; }

  // Indices of the node that entered last, of the next one, and of the one after that.
  Eigen::Index leading() const { return size() - 3; }
  Eigen::Index coming() const { return size() - 2; }
  Eigen::Index ahead() const { return size() - 1; }

  /// The first node that has not left, and the part of its way out that is left, in (0, 1].
  struct Leaving {
    Eigen::Index node;
    double inside;
  };
  Leaving leaving(double phase) const;

  /// What leaving() says of any node: <= 0 outside, and 1 where it has not begun to leave.
  double inside(Eigen::Index node, double phase) const;

  /// Nodes in the contact's frame, where its centre is x = 0; an expression  [mm]
  auto x(double phase) const {
    const double last = half_width_ - (leading_offset_ + phase) * spacing_;
    const auto node = [last, spacing = spacing_, leading = leading()](Eigen::Index i) {
      return last + static_cast<double>(i - leading) * spacing;
    };
    return Eigen::VectorXd::NullaryExpr(size(), node);
  }

  /// Means over the elements around the nodes, except that the leading one also takes what lies
  /// before its element, less what the coming one has: in proportion to its part, up to what it has
  /// when it enters. So the bound sums up to full sliding.
  /// \param coming_part  part that the coming node has of its bound, in [0, 1]; in rolling, the
  ///                     phase
  void bound(double phase, double coming_part, Eigen::VectorXd& means) const;  ///< [N/mm^2]
  Eigen::VectorXd bound(double phase) const;

  /// Gives the node that leaves, where it sticks, a bound in proportion to its part that is inside,
  /// and the rest to the next one.
  /// \param means  of bound(), in and out
  void let_leave(double phase, Eigen::VectorXd& means) const;

 private:
  double force_up_to(double x) const;

  TractionBound bound_;
  double half_width_;
  double spacing_;
  double leading_offset_;
  Eigen::Index elements_;
};

/// Moves the values of a window on by some elements; those that are new become `entering`.
template <class Vector, class Value>
void move_on(Vector& values, Eigen::Index elements, const Value& entering) {
  std::fill(std::shift_left(values.begin(), values.end(), elements), values.end(), entering);
}

}  // namespace microslip
