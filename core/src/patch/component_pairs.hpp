// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// The components along and across of one element, in a vector that has all those along first.
inline Eigen::Vector2d pair_of(const Eigen::VectorXd& values, Eigen::Index element) {
  return {values[element], values[values.size() / 2 + element]};
}

inline void set_pair(Eigen::VectorXd& values, Eigen::Index element, const Eigen::Vector2d& value) {
  values[element] = value[0];
  values[values.size() / 2 + element] = value[1];
}

/// The nearest point of the disc about 0.
inline Eigen::Vector2d onto_disc(const Eigen::Vector2d& point, double radius = 1) {
  return point.norm() > radius ? Eigen::Vector2d(radius * point.normalized()) : point;
}

}  // namespace microslip
