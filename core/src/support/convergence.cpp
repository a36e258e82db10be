// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/convergence.hpp"

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

namespace microslip {

double fitted_order(std::span<const double> sizes, std::span<const double> errors) {
  if (sizes.size() < 2 || sizes.size() != errors.size()) {
    throw std::invalid_argument("fitted_order: expected as many errors as sizes, at least two");
  }
  using Values = Eigen::Map<const Eigen::ArrayXd>;
  const auto count = static_cast<Eigen::Index>(sizes.size());
  Eigen::ArrayXd x = (Values(sizes.data(), count) / sizes[0]).log();
  x -= x.mean();
  const Eigen::ArrayXd y = Values(errors.data(), count).abs().log();
  const double slope = -(x * (y - y.mean())).sum() / x.square().sum();
  if (!std::isfinite(slope))
    throw std::invalid_argument("fitted_order: no slope through the errors");
  return slope;
}

}  // namespace microslip
