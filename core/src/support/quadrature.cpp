// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/quadrature.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <string>

#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

namespace {

constexpr std::size_t intervals = 1000;

double call(double x, void* integrand) {
  count_work(kernel_work);
  return (*static_cast<const std::function<double(double)>*>(integrand))(x);
}

}  // namespace

double integrate(const std::function<double(double)>& integrand, double begin, double end,
                 double relative) {
  // Once, as the handler belongs to all threads.
  [[maybe_unused]] static gsl_error_handler_t* const former = gsl_set_error_handler_off();
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  gsl_function function{call, const_cast<std::function<double(double)>*>(&integrand)};
  double value = 0;
  double error = 0;
  const int status = gsl_integration_qags(&function, begin, end, 0, relative, intervals,
                                          workspace.get(), &value, &error);
  // GSL's rounding test is on the safe side: what counts is the error that it estimates.
  if ((status != GSL_SUCCESS && status != GSL_EROUND) ||
      !(error <= 10 * relative * std::abs(value))) {
    throw NotConverged(std::string("quadrature: ") + gsl_strerror(status),
                       static_cast<int>(workspace->size), error / std::abs(value));
  }
  return value;
}

}  // namespace microslip
