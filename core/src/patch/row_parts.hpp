// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "microslip/patch/patch_shape.hpp"

namespace microslip {

/// The mean of v over a part of a cell or of a row, as weights of values at neighbouring centres.
struct Stencil {
  Eigen::Index first;
  Eigen::Index size;
  std::array<double, 3> weights;
};

/// A part of a cell: p = mean + slope (s - middle) for v = 1.
struct SubCell {
  double width, middle, mean, slope;  ///< in s
  Stencil along;

  /// Integrals of p and of p s over the part.
  double sum() const { return mean * width; }
  double first_moment() const { return middle * sum() + slope * width * width * width / 12; }
};

/// The parts of the cells of a row, from the leading edge on; p ds = (1 - cos) d theta.
std::vector<SubCell> sub_cells(Eigen::Index elements);

/// A part of a row, between two angles psi.
struct SubRow {
  double from, to;
  Stencil across;
};

/// The parts of the rows of a lobe, of which v is weighted by a(y) dy.
/// \param first_row  the lobe's among all rows
std::vector<SubRow> sub_rows(const Lobe& lobe, Eigen::Index first_row, Eigen::Index rows);

}  // namespace microslip
