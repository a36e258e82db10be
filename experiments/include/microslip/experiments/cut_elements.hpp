// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/experiments/cattaneo_to_carter.hpp"

namespace microslip::experiments {

/// Treatment of the elements that the moving edges of the contact cross.
enum class EdgeElements {
  at_node,    ///< whole, while the middle of the element is in contact, with the bound at the
              ///< middle
  cell_mean,  ///< whole, with the element mean of the bound
  cut         ///< only the part in contact, with the middle of this part and the mean bound over it
};

/// Cattaneo to Carter on a grid fixed to the material, with elements that may be cut. The scheme
/// does not correct for the leading edge, and is of first order. If the edges cut elements, the
/// rows and columns of these elements in the response matrix change in each step, and a step costs
/// O(N^3). Whole elements have a Toeplitz matrix: O(N^2).
///
/// The slip displacement is evaluated at the material point in the middle of each element or part:
/// S = W + u(x) - u'(x), where u' is due to the previous tractions on the previous elements and
/// parts.
class CutElementRolling {
 public:
  /// The contact after the Cattaneo shift, without rolling.
  /// \param elements  in the contact, N or any other number, at rest from the trailing edge on  [1]
  CutElementRolling(const CattaneoToCarter& rolling, EdgeElements treatment, double elements);

  /// Rolls on at constant force.
  /// \param step_ratio  c, in (0, 2]
  /// \throws std::invalid_argument outside the range
  void step(double step_ratio);

  double distance() const { return distance_; }          ///< q rolled so far  [dx]
  double creepage() const { return state_.rigid_slip; }  ///< w of the last step; zero before  [1]

  // Elements that in the last step
  Eigen::Index entered() const;   ///< entered the contact at the leading edge
  Eigen::Index left() const;      ///< left the contact at the trailing edge
  Eigen::Index released() const;  ///< began to slip, among the elements in contact before

  const Eigen::VectorXd& traction() const { return state_.traction; }  ///< [N/mm^2]
  const std::vector<Zone>& zones() const { return state_.zones; }
  Eigen::VectorXd x() const;      ///< middles of the elements in the contact's frame  [mm]
  Eigen::VectorXd width() const;  ///< of the elements or parts  [mm]
  double force() const;           ///< [N/mm]

 private:
  /// Positions in dx, fixed to the material, from the trailing edge at distance 0.
  struct Element {
    Eigen::Index number;
    double middle;
    double width;

    bool whole() const { return width == 1; }
  };
  using Elements = std::vector<Element>;

  Eigen::Index first() const { return elements_.front().number; }
  Eigen::Index end() const { return elements_.back().number + 1; }
  Elements elements_at(double distance) const;
  std::vector<Zone> zones_at(const Elements& next) const;
  Eigen::VectorXd bound(const Elements& elements, double distance) const;
  double influence_of(const Element& source, const Element& at) const;
  Eigen::MatrixXd response(const Elements& sources, const Elements& at) const;
  LinearOperator response(const Elements& elements) const;
  ContactState solve(const Elements& elements, const SlipConditions& conditions,
                     const std::vector<Zone>& first) const;

  Kernel kernel_;
  HertzBound bound_;
  double force_;
  EdgeElements treatment_;
  double contact_;           ///< length of the contact  [dx]
  double spacing_;           ///< [mm]
  ShapeFunction shape_;      ///< constant
  Eigen::VectorXd between_;  ///< influence of whole elements, by distance in elements
  double distance_ = 0;
  Elements elements_;
  ContactState state_;
  Eigen::Index previous_first_;
  Eigen::Index previous_end_;
  std::vector<Zone> previous_zones_;  ///< moved to the current elements
};

}  // namespace microslip::experiments
