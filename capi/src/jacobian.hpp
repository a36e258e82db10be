// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "zero.hpp"

namespace microslip::capi {

/// Writes a matrix row by row.
inline void put_jacobian(double* to, const Eigen::Matrix3d& jacobian) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) *to++ = without_sign_of_zero(jacobian(i, j));
  }
}

}  // namespace microslip::capi
