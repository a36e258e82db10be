// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_grid.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

using Eigen::Index;

namespace {

Index at_most_all(double cells) {
  return std::min(most_cells_of_side, static_cast<Index>(std::round(cells)));
}

/// Cells of a side over those of a circle, where the other side is `ratio` times as long.
double cells_by(double ratio) {
  constexpr double least = 60, of_circle = 200, cells_of_circle = 16;
  return std::sqrt(least + of_circle * ratio) / cells_of_circle;
}

/// The heights of all lobes together, over the largest one.
double stacked_height(const PatchShape& shape) {
  double sum = 0, highest = 0;
  for (const Lobe& lobe : shape.lobes()) {
    sum += lobe.height();
    highest = std::max(highest, lobe.height());
  }
  return sum / highest;
}

}  // namespace

bool is_patch_ratio(double ratio) {
  constexpr double rounding = 1e-12;
  return ratio >= least_patch_ratio * (1 - rounding) &&
         ratio <= largest_patch_ratio * (1 + rounding);
}

PatchGrid fitting_grid(const PatchShape& shape, double cells) {
  const auto rows = static_cast<double>(at_most_all(cells * cells_by(1 / shape.ratio())));
  return {.rows = at_most_all(rows * stacked_height(shape)),
          .elements = at_most_all(cells * cells_by(shape.ratio()))};
}

}  // namespace microslip
