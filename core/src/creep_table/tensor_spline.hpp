// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace microslip {

/// Coefficients of the uniform cubic B-spline that has given values at nodes 0 ... n - 1, from -1 to
/// n: n + 2 rows, n columns. The spline is not a knot at the second node and the last but one.
Eigen::MatrixXd spline_between_ends(Eigen::Index nodes);

/// The same for a function that is even or odd about both end nodes.
/// \param parity  1 or -1
Eigen::MatrixXd spline_between_mirrors(Eigen::Index nodes, double parity);

/// The same for a function on a great circle through the pole, from the pole to the equator, by its
/// values at the nodes and at those of the opposite meridian. It is odd under inversion, so that
/// f(pi - theta) is minus the value of the opposite meridian at theta.
struct MeridianSpline {
  Eigen::MatrixXd own, opposite;
};
MeridianSpline spline_over_pole(Eigen::Index nodes);

/// The part of an axis in which a place lies, with the four weights of the spline and their
/// derivatives by the place, which counts in nodes.
struct SplinePlace {
  std::size_t first;  ///< coefficient
  std::array<double, 4> value, slope;

  /// \param place  in [0, nodes - 1]
  SplinePlace(double place, std::size_t nodes);
};

/// Applies a matrix along an axis of an array.
/// \param before, after  products of the lengths of the axes before it, and after it
std::vector<double> along_axis(const std::vector<double>& values, const Eigen::MatrixXd& matrix,
                               std::size_t before, std::size_t after);

}  // namespace microslip
