// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/halfspace/influence.hpp"

namespace microslip::experiments {

struct NamedShape {
  std::string name;
  ShapeFunction shape;
};

/// Lists the shape functions that are the same at every node, so that their matrices are Toeplitz.
/// \param which  "constant", "linear" or "both"
std::vector<NamedShape> uniform_shapes(const std::string& which = "both");

/// Returns 2 (1 - nu) dx / G, the unit of the entries of A - A'  [mm^3/N]
double difference_unit(const Kernel& kernel, double spacing);

/// Returns A - A' over difference_unit(), n x n.
Toeplitz unit_difference(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                         Eigen::Index n, double step_ratio);

}  // namespace microslip::experiments
