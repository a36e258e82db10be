// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/chebyshev_series.hpp"

#include <boost/math/special_functions/chebyshev.hpp>
#include <numbers>

#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

ArrayXd angles(Index n) {
  const auto count = static_cast<double>(n);
  return std::numbers::pi * (ArrayXd::LinSpaced(n, 0, count - 1) + 0.5) / count;
}

}  // namespace

VectorXd chebyshev_points(double half_length, Index n) { return half_length * angles(n).cos(); }

ChebyshevSeries::ChebyshevSeries(const VectorXd& values, double half_length)
    : half_length_(half_length) {
  require_positive("half_length", half_length);
  const Index n = values.size();
  require(n > 0, "values", 0, "at least one");
  const ArrayXd at = angles(n);
  coefficients_ = VectorXd::NullaryExpr(n, [&](Index k) {
    return 2 * (values.array() * (static_cast<double>(k) * at).cos()).mean();
  });
}

double ChebyshevSeries::operator()(double x) const {
  const auto size = static_cast<std::size_t>(coefficients_.size());
  count_work(3 * static_cast<double>(size - 1));
  return boost::math::chebyshev_clenshaw_recurrence(coefficients_.data(), size, x / half_length_);
}

}  // namespace microslip
