// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"

namespace microslip {

/// The nodes near the contact, fixed to the material. A node enters the contact when the leading
/// edge has passed it by the offset that the scheme feels, see LeadingEdgeConstants. At that moment
/// the window is aligned, and moves on by one node.
///
/// From the trailing edge on the window holds one node behind the contact, N nodes in contact, the
/// node that comes next, and the one after that. The node behind is there because the displacement
/// before a step still feels its traction. A node leaves over one element's travel, which begins
/// (leading offset - 1/2) dx before the trailing edge: there the scheme feels the edge of a node
/// that sticks.
///
/// All functions depend on the phase, the distance rolled since the window was aligned, in
/// [0, 1) [dx]
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

  /// The first node that has not left, and the fraction of its way out that is left, in (0, 1].
  struct Leaving {
    Eigen::Index node;
    double inside;
  };
  Leaving leaving(double phase) const;

  /// The fraction `inside` of any node: <= 0 outside, and 1 where it has not begun to leave.
  double inside(Eigen::Index node, double phase) const;

  /// Nodes in the contact's frame, where its centre is x = 0; an expression  [mm]
  auto x(double phase) const {
    const double last = half_width_ - (leading_offset_ + phase) * spacing_;
    const auto node = [last, spacing = spacing_, leading = leading()](Eigen::Index i) {
      return last + static_cast<double>(i - leading) * spacing;
    };
    return Eigen::VectorXd::NullaryExpr(size(), node);
  }

  /// Element means of the bound. The leading node also gets the force ahead of its element, minus
  /// the share of the nodes to come, so that the sum is the force of full sliding.
  /// \param coming_share  of its bound at entry that the coming node has, in [0, 1], and that it
  ///                      shares with the node ahead; in rolling, the phase
  /// \param means         out  [N/mm^2]
  /// \param ahead_share   of that bound, in [0, coming_share]; in rolling, 0
  void bound(double phase, double coming_share, Eigen::VectorXd& means,
             double ahead_share = 0) const;
  Eigen::VectorXd bound(double phase) const;

  /// Reduces the bound of a node that leaves while it sticks to its fraction inside, and gives the
  /// rest to the next node.
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

/// Moves the values of a window on by some elements; new values are `entering`.
template <class Vector, class Value>
void move_on(Vector& values, Eigen::Index elements, const Value& entering) {
  std::fill(std::shift_left(values.begin(), values.end(), elements), values.end(), entering);
}

}  // namespace microslip
