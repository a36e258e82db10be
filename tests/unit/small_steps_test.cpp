// SPDX-License-Identifier: GPL-3.0-or-later
// Under a force the creepage is a shift over the length of a step, and the shift has rounding
// errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::small_steps_test {

/// Largest less smallest creepage of 40 equal steps, which are next to nothing, over their sum.
double noise(const AdvectionScheme& scheme, Eigen::Index n, double force, double step_ratio) {
  const double dx = 10 / static_cast<double>(n);
  TransientRolling rolling({.contact = {StripKernel({82000, 0.28}, 10), HertzBound(5, 300)},
                            .grid = Grid({.half_width = 5, .elements = n}),
                            .basis = constant_basis(),
                            .scheme = scheme},
                           CattaneoShift{force});
  for (Eigen::Index k = 0; k <= 2 * n; ++k) rolling.step(0.37 * dx, PrescribedForce{force});
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int k = 0; k < 40; ++k) {
    rolling.step(step_ratio * dx, PrescribedForce{force});
    least = std::min(least, rolling.state().creepage);
    most = std::max(most, rolling.state().creepage);
  }
  return (most - least) / std::abs(most + least);
}

TEST(SmallSteps, OfTheLeastLengthLeaveAPercentOfTheCreepage) {
  for (const AdvectionScheme& scheme :
       {AdvectionScheme(Remembered{}), AdvectionScheme(Direct{}), AdvectionScheme(Relaxed{1})}) {
    for (const Eigen::Index n : {25, 100, 400}) {
      for (const double force : {-1500., -150.}) {
        const double least = least_step_under_force(n);
        EXPECT_LT(noise(scheme, n, force, least), 0.01) << scheme.index() << ' ' << n;
      }
    }
    EXPECT_GT(noise(scheme, 100, -150, 1e-14), 0.1);  // without a word, once
  }
}

}  // namespace microslip::small_steps_test
