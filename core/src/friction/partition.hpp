// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <vector>

#include "microslip/friction/active_set.hpp"

namespace microslip {

/// What a partition answers to bound, offset and load; linear in the three.
struct Response {
  Eigen::VectorXd traction;
  Eigen::VectorXd slip;  ///< zero in adhesion
  double creepage;
};

/// The linear system of one stick/slip partition: thesis (3.19)-(3.21), with the creepage as one
/// more unknown, and one more row for what is prescribed.
class Partition {
 public:
  Partition(const SlipEquations& equations, const Load& load, const std::vector<Zone>& zones);

  /// \param prescribed  the creepage or the force
  Response respond(const Eigen::VectorXd& bound, const Eigen::VectorXd& offset,
                   double prescribed) const;

 private:
  const SlipEquations& equations_;
  bool force_prescribed_;
  Eigen::VectorXd directions_;  ///< sign of the traction in slip, 0 in adhesion
  std::vector<Eigen::Index> stuck_;
  double slip_scale_ = 1;  ///< makes the added row and column as large as the others
  double force_scale_ = 1;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace microslip
