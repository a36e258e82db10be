// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/profile.hpp"

#include <cmath>

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Returns the distance from `peak` to half its height, in the direction of `step`, +1 or -1.
double half_width(const VectorXd& values, Index peak, Index step) {
  const double half = values[peak] / 2;
  for (Index i = peak; i + step >= 0 && i + step < values.size(); i += step) {
    if (values[i + step] > half) continue;
    const double part = (values[i] - half) / (values[i] - values[i + step]);
    return std::abs(static_cast<double>(i - peak)) + part;
  }
  return static_cast<double>(step > 0 ? values.size() - 1 - peak : peak);
}

}  // namespace

Index turning_points(const VectorXd& values, double threshold) {
  Index count = 0;
  double direction = 0;
  for (Index i = 0; i + 1 < values.size(); ++i) {
    const double rise = values[i + 1] - values[i];
    if (std::abs(rise) <= threshold) continue;
    count += rise * direction < 0;
    direction = rise;
  }
  return count;
}

double total_variation(const VectorXd& values) {
  const Index n = values.size();
  return (values.tail(n - 1) - values.head(n - 1)).lpNorm<1>();
}

Peak peak_of(const VectorXd& values) {
  Index at = 0;
  const double height = values.maxCoeff(&at);
  double position = static_cast<double>(at);
  if (at > 0 && at + 1 < values.size()) {
    const double curvature = values[at - 1] - 2 * height + values[at + 1];
    if (curvature < 0) position += (values[at - 1] - values[at + 1]) / (2 * curvature);
  }
  return {height, position, half_width(values, at, -1) + half_width(values, at, 1)};
}

}  // namespace microslip::experiments
