// SPDX-License-Identifier: GPL-3.0-or-later
// Constant functions that fill the contact, while the material remembers its displacement.
#include <gtest/gtest.h>

#include <stdexcept>

#include "microslip/rolling/transient.hpp"

namespace microslip::rolling_on_elements_test {

using Eigen::Index;
using Eigen::VectorXd;

const double full_sliding = HertzBound(1, 1).total();

TransientProblem problem(const Grid::Parameters& grid) {
  return {.contact = {PlaneKernel({1, 0.28}, 200), HertzBound(1, 1)},
          .grid = Grid(grid),
          .basis = constant_basis(),
          .scheme = Remembered{}};
}

TransientProblem problem(Index n) { return problem({.half_width = 1, .elements = n}); }

double spacing_of(const TransientRolling& rolling) { return rolling.x()[1] - rolling.x()[0]; }

TEST(RollingOnElements, AnAttemptChangesNothing) {
  TransientRolling rolling(problem(40), CattaneoShift{-0.64 * full_sliding});
  const double dx = spacing_of(rolling);
  rolling.roll(10 * dx, {0.37 * dx}, PrescribedForce{-0.64 * full_sliding},
               [](const TransientState&) {});
  const TransientState tried = rolling.attempt(0.11, PrescribedCreepage{0.3});
  rolling.attempt(0.04, PrescribedCreepage{-0.3});
  rolling.step(0.11, PrescribedCreepage{0.3});
  EXPECT_LT((rolling.state().traction - tried.traction).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_NEAR(rolling.state().force, tried.force, 1e-13);
  EXPECT_EQ(rolling.state().zones, tried.zones);
}

// Tractions on the problem's grid are taken for a part of the bound.
TEST(RollingOnElements, StartsFromTractionsOnTheGrid) {
  TransientRolling rolling(problem(40));
  const VectorXd nodes = problem(40).grid.nodes();
  const VectorXd bound = bound_at(HertzBound(1, 1), nodes);
  rolling.start_from(-bound);
  EXPECT_NEAR(rolling.state().force, -full_sliding, 1e-12);
  EXPECT_EQ(rolling.state().adhesion_elements, 0);
  rolling.start_from(VectorXd(0.4 * bound.cwiseProduct(nodes)));
  for (Index i = 2; i < 39; ++i) {
    EXPECT_NEAR(rolling.state().traction[i], 0.4 * rolling.bound()[i] * rolling.x()[i], 1e-12);
  }
  EXPECT_THROW(rolling.start_from(1.1 * bound), std::invalid_argument);
}

TEST(RollingOnElements, WantsConstantFunctionsThatFillTheContact) {
  TransientProblem linear = problem(41);
  linear.basis = linear_basis();
  EXPECT_THROW(TransientRolling{linear}, std::invalid_argument);
  for (const Grid::Parameters& grid :
       {Grid::Parameters{.half_width = 1, .elements = 41, .leading_offset = 1},
        Grid::Parameters{.half_width = 1, .elements = 41, .trailing_offset = 1}}) {
    EXPECT_THROW(TransientRolling{problem(grid)}, std::invalid_argument);
  }
  EXPECT_THROW(TransientRolling{problem(3)}, std::invalid_argument);
  EXPECT_NO_THROW(TransientRolling{problem(4)});
}

// Rounding of the distance would split each of them in two, after some ten thousand.
TEST(RollingOnElements, ManyStepsOfWholeElementsStayWhole) {
  TransientRolling rolling(problem(20), CattaneoShift{-1});
  const double dx = spacing_of(rolling);
  for (int step = 0; step < 30000; ++step) {
    rolling.step(dx * 1.3, PrescribedForce{-1});
    rolling.step(dx * 0.7, PrescribedForce{-1});
  }
  EXPECT_NEAR(rolling.state().distance, 60000 * dx, 1e-9);
  rolling.step(dx, PrescribedForce{-1});
  EXPECT_EQ(rolling.state().iterations, 1);
}

}  // namespace microslip::rolling_on_elements_test
