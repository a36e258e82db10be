// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "microslip/friction/friction_law.hpp"
#include "microslip/support/archive.hpp"

namespace microslip {

/// The law by its values: at the speed of rolling, a half of it, and so on.
inline void archive_friction(Archive& archive, const SlipFriction& friction) {
  constexpr Eigen::Index values = 30;
  Eigen::VectorXd law(values);
  for (Eigen::Index i = 0; i < values; ++i) {
    law[i] = friction.law(friction.speed * std::exp2(-static_cast<double>(i)));
  }
  archive.same("friction_law", law);
  archive.same("friction_memory", friction.memory_length);
  archive.same("memory_speed", friction.memory_speed);
}

}  // namespace microslip
