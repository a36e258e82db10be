// SPDX-License-Identifier: GPL-3.0-or-later
#include "partition.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Partition::Partition(const SlipEquations& equations, const Load& load,
                     const std::vector<Zone>& zones)
    : equations_(equations),
      force_prescribed_(std::holds_alternative<PrescribedForce>(load)),
      directions_(equations.bound.size()) {
  for (Index i = 0; i < directions_.size(); ++i) {
    const Zone zone = zones[static_cast<std::size_t>(i)];
    directions_[i] = static_cast<double>(zone);
    if (zone == Zone::adhesion) stuck_.push_back(i);
  }
  const auto m = static_cast<Index>(stuck_.size());
  MatrixXd matrix = MatrixXd::Zero(m + 1, m + 1);
  if (m > 0) {
    matrix.topLeftCorner(m, m) = equations.response(stuck_, stuck_);
    slip_scale_ = matrix.cwiseAbs().maxCoeff();
    force_scale_ = slip_scale_ / equations.weights.maxCoeff();
  }
  matrix.topRightCorner(m, 1).setConstant(slip_scale_);
  if (force_prescribed_) {
    matrix.bottomLeftCorner(1, m) = force_scale_ * equations.weights(stuck_).transpose();
  } else {
    matrix(m, m) = slip_scale_;
  }
  factors_.compute(matrix);
}

Response Partition::respond(const VectorXd& bound, const VectorXd& offset,
                            double prescribed) const {
  Response result{directions_.cwiseProduct(bound), offset, 0};
  result.slip += equations_.response * result.traction;
  const auto m = static_cast<Index>(stuck_.size());
  VectorXd rhs(m + 1);
  rhs.head(m) = -result.slip(stuck_);
  rhs[m] = force_prescribed_ ? force_scale_ * (prescribed - equations_.weights.dot(result.traction))
                             : prescribed;
  const VectorXd unknowns = factors_.solve(rhs);
  result.traction(stuck_) = unknowns.head(m);
  result.creepage = slip_scale_ * unknowns[m];
  result.slip = offset + equations_.response * result.traction;
  result.slip.array() += result.creepage;
  result.slip(stuck_).setZero();
  return result;
}

}  // namespace microslip
