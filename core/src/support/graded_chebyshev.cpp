// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/graded_chebyshev.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

namespace {

constexpr std::size_t order = 15;

}  // namespace

GradedChebyshev::GradedChebyshev(const std::function<double(double)>& function, double nearest,
                                 double farthest)
    : nearest_(nearest) {
  double before = 0;
  double begin = nearest;
  do {
    const ChebyshevSeries values(function, begin, 2 * begin, order);
    const ChebyshevSeries integral = values.integral();
    intervals_.push_back({values, integral, before});
    begin *= 2;
    before += integral(begin);
  } while (begin < farthest);
}

const GradedChebyshev::Interval& GradedChebyshev::interval(double distance) const {
  const int doublings = std::max(0, std::ilogb(distance / nearest_));
  return intervals_[std::min(static_cast<std::size_t>(doublings), intervals_.size() - 1)];
}

double GradedChebyshev::operator()(double distance) const {
  return interval(distance).values(distance);
}

double GradedChebyshev::integral(double distance) const {
  const Interval& within = interval(distance);
  return within.before + within.integral(distance);
}

}  // namespace microslip
