// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/quadrature/gauss.hpp>

namespace microslip {

/// Calls take(position, weight) with the points of the Gauss-Legendre rule of an interval, from its
/// middle outwards.
/// \tparam points  their number, up to 100
template <unsigned points, class Take>
void for_gauss_points(double begin, double end, const Take& take) {
  using Rule = boost::math::quadrature::gauss<double, points>;
  const double half = (end - begin) / 2;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
    const double x = Rule::abscissa()[k], weight = half * Rule::weights()[k];
    take(begin + half * (1 - x), weight);
    if (x != 0) take(begin + half * (1 + x), weight);
  }
}

}  // namespace microslip
