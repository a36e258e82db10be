// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace microslip {

/// The interpolation between points is cubic.
inline constexpr Eigen::Index fewest_points = 4;

/// The value at index i + shift of values at whole indices, cubic.
/// \param shift  in [0, 1]
/// \param from   the values used have this index at least
inline double interpolated_at(const Eigen::VectorXd& values, Eigen::Index i, double shift,
                              Eigen::Index from) {
  if (shift <= 0) return values[i];
  if (shift >= 1) return values[i + 1];
  const Eigen::Index last = values.size() - fewest_points;
  const Eigen::Index a = std::clamp(i - 1, std::min(from, last), last);
  const double z = static_cast<double>(i - a) + shift;
  const auto factor = [z](Eigen::Index k) { return z - static_cast<double>(k); };
  return -factor(1) * factor(2) * factor(3) / 6 * values[a] +
         factor(0) * factor(2) * factor(3) / 2 * values[a + 1] -
         factor(0) * factor(1) * factor(3) / 2 * values[a + 2] +
         factor(0) * factor(1) * factor(2) / 6 * values[a + 3];
}

/// Its derivative by the shift.
inline double slope_at(const Eigen::VectorXd& values, Eigen::Index i, double shift,
                       Eigen::Index from) {
  const Eigen::Index last = values.size() - fewest_points;
  const Eigen::Index a = std::clamp(i - 1, std::min(from, last), last);
  const double z = static_cast<double>(i - a) + shift;
  const double z2 = z * z;
  return (-(3 * z2 - 12 * z + 11) / 6) * values[a] + (3 * z2 - 10 * z + 6) / 2 * values[a + 1] -
         (3 * z2 - 8 * z + 3) / 2 * values[a + 2] + (3 * z2 - 6 * z + 2) / 6 * values[a + 3];
}

}  // namespace microslip
