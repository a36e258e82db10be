// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/chebyshev_series.hpp"

#include <gsl/gsl_chebyshev.h>

#include "microslip/support/work.hpp"

namespace microslip {

namespace {

std::shared_ptr<gsl_cheb_series> empty_series(std::size_t order) {
  return {gsl_cheb_alloc(order), gsl_cheb_free};
}

double evaluate(double x, void* function) {
  return (*static_cast<std::function<double(double)>*>(function))(x);
}

}  // namespace

ChebyshevSeries::ChebyshevSeries(const std::function<double(double)>& function, double begin,
                                 double end, std::size_t order) {
  std::function<double(double)> copy = function;
  const gsl_function wrapped{evaluate, &copy};
  const auto series = empty_series(order);
  gsl_cheb_init(series.get(), &wrapped, begin, end);
  series_ = series;
}

double ChebyshevSeries::operator()(double x) const {
  count_work(3 * static_cast<double>(gsl_cheb_order(series_.get())));
  return gsl_cheb_eval(series_.get(), x);
}

ChebyshevSeries ChebyshevSeries::integral() const {
  const auto integral = empty_series(gsl_cheb_order(series_.get()));
  gsl_cheb_calc_integ(integral.get(), series_.get());
  return ChebyshevSeries(Series(integral));
}

}  // namespace microslip
