// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/full_sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

// Few places are evaluated one by one, many interpolated.
TEST(FullSliding, StrainAtManyPlacesIsThatAtEach) {
  const PolynomialBound bound(2, 3, Eigen::Vector3d(1, 0.3, -0.2));
  for (const double width : {0.5, 4.0, 100.0}) {
    const FullSliding sliding(StripKernel({1, 0.28}, width), bound);
    for (const Eigen::Index n : {2, 40, 3000}) {
      const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1.99, 1.97);
      const Eigen::VectorXd strain = sliding.strain(x);
      double worst = 0;
      for (Eigen::Index i = 0; i < n; ++i) {
        worst = std::max(worst, std::abs(strain[i] - sliding.strain(x[i])));
      }
      EXPECT_LE(worst, 1e-13 * strain.lpNorm<Eigen::Infinity>()) << width << " " << n;
    }
  }
}

TEST(FullSliding, RefusesTables) {
  const TabulatedBound table(1, Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1));
  EXPECT_THROW(FullSliding(PlaneKernel({1, 0.28}, 10), table), std::invalid_argument);
}

}  // namespace
}  // namespace microslip
