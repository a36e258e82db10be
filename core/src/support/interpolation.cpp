// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/interpolation.hpp"

#include <algorithm>

namespace microslip {

using Eigen::VectorXd;

double interpolated(const VectorXd& positions, const VectorXd& values, double x) {
  const auto after = std::upper_bound(positions.begin(), positions.end(), x) - positions.begin();
  if (after == 0) return values[0];
  if (after == positions.size()) return values[positions.size() - 1];
  const double part = (x - positions[after - 1]) / (positions[after] - positions[after - 1]);
  return (1 - part) * values[after - 1] + part * values[after];
}

VectorXd interpolated(const VectorXd& positions, const VectorXd& values, const VectorXd& x) {
  return x.unaryExpr([&](double xi) { return interpolated(positions, values, xi); });
}

}  // namespace microslip
