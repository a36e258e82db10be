// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"

namespace microslip {

/// How the bound of an element follows the contact.
enum class MovingBound {
  at_node,   ///< that of its node: elements enter and leave at once
  cell_mean  ///< the mean over the element: they enter and leave by and by
};

/// A grid that is fixed to the material, and of which only the part near the contact is kept: it
/// moves along by whole elements, so that no traction is ever interpolated. Its leading element is
/// the one that holds the leading edge. Behind the contact it keeps those that a step may just have
/// left, because the displacement before the step still feels their tractions.
///
/// It is a function of the distance rolled; at none the elements fill the contact.
class MaterialWindow {
 public:
  /// \param grid        with offsets 1/2
  /// \param kept        elements behind the contact, at least the largest step ratio
  /// \throws std::invalid_argument for other offsets
  MaterialWindow(const TractionBound& bound, const Grid& grid, MovingBound moving_bound,
                 Eigen::Index kept);

  Eigen::Index size() const { return elements_ + 1 + kept_; }
  Eigen::Index kept() const { return kept_; }

  /// Element centres in the contact's frame, where its centre is x = 0  [mm]
  /// \param distance  q, >= 0  [mm]
  Eigen::VectorXd x(double distance) const;

  /// [N/mm^2]
  Eigen::VectorXd bound(double distance) const;

  /// By how many elements the window moves between two distances.
  Eigen::Index elements_between(double before, double after) const;

 private:
  double leading_element(double distance) const;

  TractionBound bound_;
  MovingBound moving_bound_;
  double half_width_;
  double spacing_;
  Eigen::Index elements_;
  Eigen::Index kept_;
};

/// Values of a window that has moved on by some elements; `entering` for those that are new.
template <class Vector, class Value>
Vector moved_on(const Vector& values, Eigen::Index elements, const Value& entering) {
  Vector moved = values;
  const auto n = static_cast<Eigen::Index>(values.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto to = static_cast<decltype(values.size())>(i);
    const auto from = static_cast<decltype(values.size())>(i + elements);
    moved[to] = i + elements < n ? values[from] : entering;
  }
  return moved;
}

}  // namespace microslip
