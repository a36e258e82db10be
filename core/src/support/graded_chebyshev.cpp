// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/graded_chebyshev.hpp"

#include <gsl/gsl_chebyshev.h>

#include <algorithm>
#include <cmath>

namespace microslip {

namespace {

constexpr std::size_t order = 19;

double evaluate(double x, void* function) {
  return (*static_cast<const std::function<double(double)>*>(function))(x);
}

}  // namespace

GradedChebyshev::GradedChebyshev(const std::function<double(double)>& function, double nearest,
                                 double farthest)
    : nearest_(nearest) {
  std::function<double(double)> copy = function;
  const gsl_function wrapped{evaluate, &copy};
  double begin = nearest;
  do {
    const std::shared_ptr<gsl_cheb_series> series(gsl_cheb_alloc(order), gsl_cheb_free);
    gsl_cheb_init(series.get(), &wrapped, begin, 2 * begin);
    series_.push_back(series);
    begin *= 2;
  } while (begin < farthest);
}

double GradedChebyshev::operator()(double distance) const {
  const int doublings = std::max(0, std::ilogb(distance / nearest_));
  const auto interval = std::min(static_cast<std::size_t>(doublings), series_.size() - 1);
  return gsl_cheb_eval(series_[interval].get(), distance);
}

}  // namespace microslip
