// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_displacements.hpp"

#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector2d;

void PointDisplacements::set(const Eigen::VectorXd& unknowns, double factor) {
  unknowns_ = &unknowns;
  factor_ = factor;
  for (Known& one : known_) one.is_known = false;
}

Vector2d PointDisplacements::at(Index j, Index k) {
  const Index point = rows_->point(j, k);
  Known& one = known_[static_cast<std::size_t>(point)];
  if (!one.is_known) {
    one.value = factor_ * Vector2d(by_traction_->row(point).dot(*unknowns_),
                                   by_traction_->row(rows_->points() + point).dot(*unknowns_));
    one.is_known = true;
  }
  return one.value;
}

Vector2d PointDisplacements::at_angle(double theta, Index k) {
  const PointSlip points = between(*rows_, theta);
  Vector2d value = Vector2d::Zero();
  for (std::size_t l = 0; l < 4; ++l) value += points.weights[l] * at(points.points[l], k);
  return value;
}

}  // namespace microslip
