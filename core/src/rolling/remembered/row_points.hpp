// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace microslip {

/// A cubic needs so many points.
inline constexpr Eigen::Index fewest_points = 4;

/// The nodes of a row on the problem's contact. On another contact, nodes keep their places over
/// the half-width. The entry is one element ahead of the last node, the exit one element behind
/// the first.
struct RowNodes {
  Eigen::Index size = 0;  ///< N
  double spacing = 0;     ///< dx  [mm]
  double first = 0;       ///< x of the first node over dx

  /// Returns the place of the entry over dx.
  double entry() const { return first + static_cast<double>(size); }
};

/// Where nodes stand among the nodes of an earlier time, on the same material: node i is i + of(i)
/// elements from the first earlier node.
struct NodeShift {
  double first = 0;    ///< of node 0
  double stretch = 0;  ///< the ratio of the elements' lengths, now over then, less 1

  double of(Eigen::Index i) const { return first + stretch * static_cast<double>(i); }
};

/// Displacements at the nodes, at the entry and at the exit; or at the points of the material that
/// were there.
struct RowPoints {
  Eigen::VectorXd at;  ///< N + 1  [mm]
  double exit = 0;     ///< [mm]

  void set_zero() {
    at.setZero();
    exit = 0;
  }
  void subtract(double shift) {
    at.array() -= shift;
    exit -= shift;
  }
};

/// Returns the index of the first of the four values that a cubic at index i uses.
inline Eigen::Index first_of_cubic(const Eigen::VectorXd& values, Eigen::Index i,
                                   Eigen::Index from) {
  const Eigen::Index last = values.size() - fewest_points;
  return std::clamp(i - 1, std::min(from, last), last);
}

/// Moves whole elements of a shift to the index, so that the shift is within [0, 1], unless it is
/// farther than any contact goes. A shift that is not a number counts as the farthest.
inline void take_whole_elements(Eigen::Index& i, double& shift) {
  constexpr double farthest = 1e15;
  if (shift >= 0 && shift <= 1) return;
  const double whole = std::fmin(std::fmax(std::floor(shift), -farthest), farthest);
  i += static_cast<Eigen::Index>(whole);
  shift -= whole;
}

/// Interpolates values at whole indices to i + shift: by a cubic; linearly to the exit.
/// \param from  only values from this index on are used
inline double interpolated_at(const RowPoints& points, Eigen::Index i, double shift,
                              Eigen::Index from) {
  const Eigen::VectorXd& values = points.at;
  take_whole_elements(i, shift);
  if (i < 0) return i == -1 ? std::lerp(points.exit, values[0], shift) : points.exit;
  if (shift == 0 && i < values.size()) return values[i];
  if (shift == 1 && i + 1 < values.size()) return values[i + 1];
  const Eigen::Index a = first_of_cubic(values, i, from);
  const double z = static_cast<double>(i - a) + shift;
  const auto factor = [z](Eigen::Index k) { return z - static_cast<double>(k); };
  return -factor(1) * factor(2) * factor(3) / 6 * values[a] +
         factor(0) * factor(2) * factor(3) / 2 * values[a + 1] -
         factor(0) * factor(1) * factor(3) / 2 * values[a + 2] +
         factor(0) * factor(1) * factor(2) / 6 * values[a + 3];
}

/// Returns the derivative of interpolated_at() by the shift.
inline double slope_at(const RowPoints& points, Eigen::Index i, double shift, Eigen::Index from) {
  const Eigen::VectorXd& values = points.at;
  take_whole_elements(i, shift);
  if (i < 0) return i == -1 ? values[0] - points.exit : 0;
  const Eigen::Index a = first_of_cubic(values, i, from);
  const double z = static_cast<double>(i - a) + shift;
  const double z2 = z * z;
  return (-(3 * z2 - 12 * z + 11) / 6) * values[a] + (3 * z2 - 10 * z + 6) / 2 * values[a + 1] -
         (3 * z2 - 8 * z + 3) / 2 * values[a + 2] + (3 * z2 - 6 * z + 2) / 6 * values[a + 3];
}

}  // namespace microslip
