// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

struct gsl_cheb_series_struct;

namespace microslip {

/// A function of the distance from a point, analytic for all positive distances: Chebyshev series
/// over intervals that double. For functions that are dear to evaluate at many places.
/// Accuracy: 1e-13 of its size on an interval if the nearest singularity is at distance 0.
/// Cost: 20 evaluations an interval.
class GradedChebyshev {
 public:
  /// \param function  of the distance
  /// \param nearest   and `farthest` distance, 0 < nearest <= farthest
  GradedChebyshev(const std::function<double(double)>& function, double nearest, double farthest);

  /// \param distance  within [nearest, farthest]
  double operator()(double distance) const;

 private:
  double nearest_;
  std::vector<std::shared_ptr<const gsl_cheb_series_struct>> series_;
};

}  // namespace microslip
