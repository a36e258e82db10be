// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_edges.hpp"

#include <numbers>

namespace microslip {

RowEdges::RowEdges(const Kernel& kernel, double spacing)
    : constants_(leading_edge_constants(constant_basis(), softness(kernel, spacing))),
      compliance_(constants_.compliance *
                  (std::numbers::pi * kernel.log_factor() * spacing + kernel.layer_compliance())) {}

Grid RowEdges::nodes(double half_width, Eigen::Index elements) const {
  return Grid({.half_width = half_width,
               .elements = elements,
               .leading_offset = constants_.offset,
               .trailing_offset = 1 - constants_.offset});
}

}  // namespace microslip
