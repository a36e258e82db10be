// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/experiments/cut_elements.hpp"

namespace microslip::experiments {

/// Cattaneo to Carter on whole elements that are fixed to the material, as in a plain world-fixed
/// grid. The scheme does not correct for the leading edge, and is of first order. Results equal
/// CutElementRolling without cut elements, at O(N^2) per step.
class WholeElementRolling {
 public:
  /// The contact after the Cattaneo shift, without rolling.
  /// \param treatment  at_node or cell_mean
  /// \throws std::invalid_argument for cut
  WholeElementRolling(const CattaneoToCarter& rolling, EdgeElements treatment);

  /// Rolls on at constant force.
  /// \param step_ratio  c, in (0, 2]
  /// \throws std::invalid_argument outside the range
  void step(double step_ratio);

  double creepage() const { return state_.creepage; }  ///< w of the last step; zero before  [1]

  // Values of all elements; some elements behind the contact, without traction, are included.
  const Eigen::VectorXd& traction() const { return state_.traction; }  ///< [N/mm^2]
  const Eigen::VectorXd& bound() const { return bound_; }              ///< [N/mm^2]
  const std::vector<Zone>& zones() const { return state_.zones; }
  Eigen::VectorXd x() const;  ///< middles of the elements in the contact's frame  [mm]

 private:
  double leading_element(double distance) const;
  Eigen::VectorXd bound_now() const;

  HertzBound hertz_;
  double force_;
  EdgeElements treatment_;
  Eigen::Index elements_;
  double spacing_;
  double distance_ = 0;  ///< [dx]
  ActiveSet active_set_;
  Eigen::VectorXd bound_;
  ContactState state_;
};

}  // namespace microslip::experiments
