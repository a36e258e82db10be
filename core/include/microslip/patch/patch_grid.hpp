// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "microslip/patch/patch_shape.hpp"

namespace microslip {

/// The ratios a/b at which rows are known to converge: tests/property/generated_patches_test.cpp
inline constexpr double least_patch_ratio = 1e-3, largest_patch_ratio = 10;

/// Whether a ratio is one of these, but for rounding.
bool is_patch_ratio(double ratio);

/// The largest number of rows, and of elements of a row.
inline constexpr Eigen::Index most_cells_of_side = 100;

struct PatchGrid {
  Eigen::Index rows;      ///< M
  Eigen::Index elements;  ///< N of each row
};

/// The rows and elements that fit a shape, a smooth function of it, and in each lobe as many rows as
/// its height says.
/// \param cells  rows, and elements of each, on a circle
PatchGrid fitting_grid(const PatchShape& shape, double cells = 16);

}  // namespace microslip
