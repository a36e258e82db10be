// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/graded_chebyshev.hpp"

#include <gsl/gsl_chebyshev.h>

#include <algorithm>
#include <cmath>

namespace microslip {

namespace {

constexpr std::size_t order = 15;

double evaluate(double x, void* function) {
  return (*static_cast<const std::function<double(double)>*>(function))(x);
}

std::shared_ptr<gsl_cheb_series> empty_series() { return {gsl_cheb_alloc(order), gsl_cheb_free}; }

}  // namespace

GradedChebyshev::GradedChebyshev(const std::function<double(double)>& function, double nearest,
                                 double farthest)
    : nearest_(nearest) {
  std::function<double(double)> copy = function;
  const gsl_function wrapped{evaluate, &copy};
  double before = 0;
  double begin = nearest;
  do {
    const auto values = empty_series();
    const auto integral = empty_series();
    gsl_cheb_init(values.get(), &wrapped, begin, 2 * begin);
    gsl_cheb_calc_integ(integral.get(), values.get());
    intervals_.push_back({values, integral, before});
    begin *= 2;
    before += gsl_cheb_eval(integral.get(), begin);
  } while (begin < farthest);
}

const GradedChebyshev::Interval& GradedChebyshev::interval(double distance) const {
  const int doublings = std::max(0, std::ilogb(distance / nearest_));
  return intervals_[std::min(static_cast<std::size_t>(doublings), intervals_.size() - 1)];
}

double GradedChebyshev::operator()(double distance) const {
  return gsl_cheb_eval(interval(distance).values.get(), distance);
}

double GradedChebyshev::integral(double distance) const {
  const Interval& within = interval(distance);
  return within.before + gsl_cheb_eval(within.integral.get(), distance);
}

}  // namespace microslip
