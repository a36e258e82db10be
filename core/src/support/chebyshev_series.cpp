// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/chebyshev_series.hpp"

#include <gsl/gsl_chebyshev.h>

#include <stdexcept>

#include "gsl.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

namespace {

std::shared_ptr<gsl_cheb_series> empty_series(std::size_t order) {
  return gsl::owned<gsl_cheb_series>([&] { return gsl_cheb_alloc(order); }, gsl_cheb_free);
}

}  // namespace

ChebyshevSeries::ChebyshevSeries(const std::function<double(double)>& function, double begin,
                                 double end, std::size_t order) {
  // GSL's status is always success here.
  if (!(begin < end)) throw std::invalid_argument("Chebyshev series: expected begin < end");
  const gsl::Function values(function);
  const auto series = empty_series(order);
  const int status =
      gsl::quietly([&] { return gsl_cheb_init(series.get(), values.get(), begin, end); });
  values.rethrow();
  gsl::require_success(status, "Chebyshev series");
  series_ = series;
}

double ChebyshevSeries::operator()(double x) const {
  count_work(3 * static_cast<double>(gsl_cheb_order(series_.get())));
  return gsl_cheb_eval(series_.get(), x);  // reports no errors
}

}  // namespace microslip
