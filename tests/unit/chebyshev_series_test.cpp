// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/chebyshev_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace microslip::chebyshev_series_test {

using Eigen::VectorXd;

TEST(ChebyshevSeries, ReproducesPolynomials) {
  const auto cubic = [](double x) { return 1 + x * (2 - x * (3 - x)); };
  const ChebyshevSeries series(chebyshev_points(2, 4).unaryExpr(cubic), 2);
  for (const double x : {-2.0, -0.3, 0.0, 1.7, 2.0}) EXPECT_NEAR(series(x), cubic(x), 1e-14) << x;
  EXPECT_EQ(ChebyshevSeries(VectorXd::Constant(1, 7), 2)(1), 7);
}

TEST(ChebyshevSeries, ConvergesToAnalyticFunctions) {
  const auto function = [](double x) { return std::exp(x) / (1 + x * x); };
  const ChebyshevSeries series(chebyshev_points(0.5, 30).unaryExpr(function), 0.5);
  for (const double x : {-0.5, 0.01, 0.49}) EXPECT_NEAR(series(x), function(x), 1e-14) << x;
}

// Points are taken some at a time; here they are more than that, fewer, and none.
TEST(ChebyshevSeries, HasTheSameValuesAtManyPoints) {
  const auto function = [](double x) { return std::exp(x) / (1 + x * x); };
  const ChebyshevSeries series(chebyshev_points(0.5, 30).unaryExpr(function), 0.5);
  for (const Eigen::Index count : {0, 1, 7, 8, 21}) {
    const VectorXd x = VectorXd::LinSpaced(count, -0.5, 0.5);
    const VectorXd values = series(x);
    ASSERT_EQ(values.size(), count);
    for (Eigen::Index i = 0; i < count; ++i) EXPECT_NEAR(values[i], function(x[i]), 1e-14) << x[i];
  }
}

TEST(ChebyshevSeries, RefusesNoValuesAndNoInterval) {
  EXPECT_THROW(ChebyshevSeries(VectorXd(), 1), std::invalid_argument);
  EXPECT_THROW(ChebyshevSeries(VectorXd::Ones(4), 0), std::invalid_argument);
}

}  // namespace microslip::chebyshev_series_test
