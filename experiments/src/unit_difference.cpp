// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit_difference.hpp"

namespace microslip::experiments {

std::vector<NamedShape> uniform_shapes(const std::string& which) {
  std::vector<NamedShape> shapes;
  if (which != "linear") shapes.push_back({"constant", constant_shape()});
  if (which != "constant") shapes.push_back({"linear", linear_shape()});
  return shapes;
}

double difference_unit(const Kernel& kernel, double spacing) {
  return compliance(kernel.material()) * spacing;
}

Toeplitz unit_difference(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                         Eigen::Index n, double step_ratio) {
  const double unit = difference_unit(kernel, spacing);
  const Toeplitz b = influence_difference_toeplitz(kernel, shape, spacing, n, step_ratio);
  return {Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return b(k, 0) / unit; }),
          Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return b(0, k) / unit; })};
}

}  // namespace microslip::experiments
