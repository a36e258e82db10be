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

/// The functions that are the same at every node, so that their matrices are Toeplitz.
/// \param which  "constant", "linear" or "both"
std::vector<NamedShape> uniform_shapes(const std::string& which = "both");

/// 2 (1 - nu) dx / G, in which entries of A - A' are given  [mm^3/N]
double difference_unit(const Kernel& kernel, double spacing);

/// A - A' in that unit, n x n.
Toeplitz unit_difference(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                         Eigen::Index n, double step_ratio);

}  // namespace microslip::experiments
