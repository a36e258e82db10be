// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/steady.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "microslip/halfspace/influence.hpp"

namespace microslip::steady_test {

constexpr Material material{1, 0.28};

SteadyProblem problem(Load load) {
  return {.contact = {StripKernel(material, 5), HertzBound(1, 1)},
          .grid = Grid({.half_width = 1, .elements = 40}),
          .basis = constant_basis(),
          .method = Differences{},
          .load = load};
}

TEST(Steady, SlipIsCreepagePlusTheDisplacementDifference) {
  const SteadySolution s = solve_steady(problem(PrescribedCreepage{0.4}));
  const double dx = s.x[1] - s.x[0];
  for (Eigen::Index i = 0; i + 1 < s.x.size(); ++i) {
    EXPECT_NEAR(s.slip[i], 0.4 - (s.displacement[i + 1] - s.displacement[i]) / dx, 1e-12);
  }
}

TEST(Steady, TotalsAreThoseOfTheNodes) {
  const SteadySolution s = solve_steady(problem(PrescribedForce{-0.8}));
  const double dx = s.x[1] - s.x[0];
  EXPECT_NEAR(s.force, -0.8, 1e-13);
  EXPECT_NEAR(dx * s.traction.sum(), -0.8, 1e-13);
  EXPECT_DOUBLE_EQ(s.dissipation, 0.8 * s.creepage);
  EXPECT_EQ(s.adhesion_elements() + s.slip_elements(), 40);
  EXPECT_GT(s.creepage, 0);
}

// Results scale with G, a and the peak traction: p ~ peak, w ~ peak / G, u ~ a peak / G.
TEST(Steady, IsScaleInvariant) {
  const SteadySolution s = solve_steady(problem(PrescribedCreepage{0.4}));
  const double g = 8e4, a = 6, peak = 300;
  const SteadySolution t =
      solve_steady({.contact = {StripKernel({g, 0.28}, 5 * a), HertzBound(a, peak)},
                    .grid = Grid({.half_width = a, .elements = 40}),
                    .basis = constant_basis(),
                    .method = Differences{},
                    .load = PrescribedCreepage{0.4 * peak / g}});
  EXPECT_NEAR((t.traction / peak - s.traction).lpNorm<Eigen::Infinity>(), 0, 1e-12);
  EXPECT_NEAR((t.displacement * g / (a * peak) - s.displacement).lpNorm<Eigen::Infinity>(), 0,
              1e-12);
}

TEST(Steady, TheReferenceLengthMovesOnlyTheDisplacement) {
  const auto with_length = [&](double length) {
    SteadyProblem p = problem(PrescribedForce{-0.8});
    p.contact.kernel = PlaneKernel(material, length);
    return solve_steady(p);
  };
  const SteadySolution near = with_length(10);
  const SteadySolution far = with_length(1000);
  EXPECT_EQ(near.traction, far.traction);
  const Eigen::VectorXd moved = far.displacement - near.displacement;
  EXPECT_NEAR(moved.maxCoeff() - moved.minCoeff(), 0, 1e-12);
  EXPECT_LT(moved.maxCoeff(), -0.1);
}

TEST(Steady, RejectsAStepThatIsNotPositive) {
  SteadyProblem p = problem(PrescribedCreepage{0.4});
  p.method = Differences{.step_ratio = 0};
  EXPECT_THROW(solve_steady(p), std::invalid_argument);
}

}  // namespace microslip::steady_test
