// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/patch/patch_shape.hpp"

namespace microslip {

/// Points of one y in a lobe, by rising s = (x - middle)/half-length, from -1 to 1.
struct PointRow {
  double y;
  std::vector<double> s;
  std::vector<Eigen::Index> points;  ///< places in the table
};

/// Points of a table in the lobes of a shape.
struct PointRows {
  std::vector<std::vector<PointRow>> lobes;  ///< rows by rising y
  std::vector<Eigen::Index> outside;         ///< points outside the shape
};

/// Sorts points into rows. A point belongs to the shape up to 1e-4 of a row's half-length beyond an
/// edge, as tables are printed with few digits.
/// \throws std::invalid_argument if a number is not finite, or a point is there twice; the message
///         names the row of the table, from 1 on
PointRows rows_of_points(const PatchShape& shape, const Eigen::VectorXd& x,
                         const Eigen::VectorXd& y);

/// Refuses rows that say little of a lobe.
/// \param y     of the rows, rising
/// \param most  number of points of the longest row
/// \param name  of the values, as in "number of y with a bound > 0"
/// \throws std::invalid_argument with less than three rows, a third of the height without a row, or
///         no row with three points
void require_rows(const Lobe& lobe, const std::vector<double>& y, std::size_t most,
                  const char* name);

}  // namespace microslip
