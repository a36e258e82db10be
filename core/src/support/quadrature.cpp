// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/quadrature.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <string>

#include "gsl.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

double integrate(const std::function<double(double)>& integrand, double begin, double end,
                 double relative) {
  constexpr std::size_t intervals = 1000;
  const std::function<double(double)> counted = [&](double x) {
    count_work(kernel_work);
    return integrand(x);
  };
  const gsl::Function function(counted);
  const auto workspace = gsl::owned<gsl_integration_workspace>(
      [] { return gsl_integration_workspace_alloc(intervals); }, gsl_integration_workspace_free);
  double value = 0;
  double error = 0;
  const int status = gsl::quietly([&] {
    return gsl_integration_qags(function.get(), begin, end, 0, relative, intervals, workspace.get(),
                                &value, &error);
  });
  function.rethrow();
  // GSL's test for rounding errors is pessimistic, so that only the estimated error counts.
  if ((status != GSL_SUCCESS && status != GSL_EROUND) ||
      !(error <= 10 * relative * std::abs(value))) {
    throw NotConverged(std::string("quadrature: ") + gsl_strerror(status),
                       static_cast<int>(workspace->size), error / std::abs(value));
  }
  return value;
}

}  // namespace microslip
