// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/convergence.hpp"

#include <gsl/gsl_fit.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "gsl.hpp"

namespace microslip {

double fitted_order(std::span<const double> sizes, std::span<const double> errors) {
  if (sizes.size() < 2 || sizes.size() != errors.size()) {
    throw std::invalid_argument("fitted_order: expected as many errors as sizes, at least two");
  }
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    x.push_back(std::log(sizes[i]));
    y.push_back(-std::log(std::abs(errors[i])));
  }
  double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
  gsl::require_success(gsl::quietly([&] {
                         return gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept,
                                               &slope, &c00, &c01, &c11, &residual);
                       }),
                       "fitted_order");
  if (!std::isfinite(slope))
    throw std::invalid_argument("fitted_order: no slope through the errors");
  return slope;
}

}  // namespace microslip
