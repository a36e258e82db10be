// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

struct gsl_cheb_series_struct;

namespace microslip {

/// Interpolates a function on an interval between its values at Chebyshev points.
class ChebyshevSeries {
 public:
  /// \param end    > begin
  /// \param order  the degree; the function is evaluated order + 1 times
  /// \throws std::invalid_argument outside the range
  ChebyshevSeries(const std::function<double(double)>& function, double begin, double end,
                  std::size_t order);

  double operator()(double x) const;

 private:
  using Series = std::shared_ptr<const gsl_cheb_series_struct>;

  Series series_;
};

}  // namespace microslip
