// SPDX-License-Identifier: GPL-3.0-or-later
// Steady rolling of an ellipse: limits in closed form, invariances, and results of another program.
#include "microslip/patch/steady_patch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/reference/carter.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::steady_patch_test {

using Eigen::Vector3d;
using std::numbers::pi;

PatchLoad rolling(double creepage, double lateral, double spin) {
  return {{{false, creepage}, {false, lateral}, {false, spin}}};
}

/// A circle of the size 1, with a modulus and a peak of 1.
SteadyPatch circle(int size, const PatchLoad& load) {
  return {.material = {1, 0.25},
          .bound = EllipticBound(1, 1, 1),
          .rows = size,
          .elements = size,
          .load = load};
}

/// Resultants over full sliding, and over full sliding by the size.
Vector3d relative(const SteadyPatch& problem, const SteadyPatchSolution& solution) {
  return solution.resultants.cwiseQuotient(problem.bound.total() *
                                           Vector3d(1, 1, problem.bound.size()));
}

Vector3d relative(const SteadyPatch& problem) { return relative(problem, solve_steady(problem)); }

TEST(EllipticBound, HasTheForceAndTheMomentOfItsIntegrals) {
  const EllipticBound bound(3, 2, 5);
  constexpr int parts = 400;
  double force = 0, moment = 0;
  for (int i = 0; i < parts; ++i) {
    for (int k = 0; k < parts; ++k) {
      const double x = 3 * ((i + 0.5) * 2 / parts - 1), y = 2 * ((k + 0.5) * 2 / parts - 1);
      const double area = 24.0 / parts / parts;
      force += area * bound(x, y);
      moment += area * bound(x, y) * std::hypot(x, y);
    }
  }
  EXPECT_NEAR(bound.total(), force, 1e-4 * force);
  EXPECT_NEAR(bound.turning_moment(), moment, 1e-4 * moment);
}

// Values of CONTACT v25.2 for G = 1, nu = 0.28 on a circle with mu p0 = 0.45/pi, extrapolated from
// 28 to 160 elements a diameter. Their last digits are uncertain where adhesion is large: by 1e-3
// of full sliding.
TEST(SteadyPatch, HasTheForcesThatContactTendsTo) {
  const struct {
    Vector3d motion, over_full_sliding;
    double error_of_20;
  } cases[] = {
      {{0.07, 0, 0}, {-0.7153, 0, 0}, 0.0012},      {{0.14, 0, 0}, {-0.9786, 0, 0}, 0.0005},
      {{0, 0.08, 0}, {0, -0.7118, 0.1253}, 0.0008}, {{0, 0.16, 0}, {0, -0.9751, 0.0386}, 0.0005},
      {{0, 0, 0.1}, {0, -0.4498, -0.2617}, 0.0005}, {{0, 0, 0.2}, {0, -0.6073, -0.3992}, 0.002},
      {{0, 0, 0.4}, {0, -0.4390, -0.4898}, 0.003},  {{0, 0, 0.8}, {0, -0.2745, -0.5494}, 0.003},
  };
  for (const auto& [motion, expected, error] : cases) {
    const SteadyPatch problem{.material = {1, 0.28},
                              .bound = EllipticBound(1, 1, 0.45 / pi),
                              .rows = 20,
                              .elements = 20,
                              .load = rolling(motion[0], motion[1], motion[2])};
    EXPECT_LT((relative(problem) - expected).cwiseAbs().maxCoeff(), error) << motion.transpose();
  }
}

TEST(SteadyPatch, FollowsKalkersTheoryUnderSmallLoads) {
  const JoinedRows rows(2, 6, 8);
  const PatchResponse response(rows, 0.3);
  const SteadyPatch problem{.material = {80000, 0.3},
                            .bound = EllipticBound(6, 3, 1e12),
                            .rows = 6,
                            .elements = 8,
                            .load = rolling(1e-3, 2e-3, -3e-4)};
  const SteadyPatchSolution solution = solve_steady(problem);
  const double c2 = 18, c = std::sqrt(c2);
  const Vector3d linear = 8e4 * c2 * Vector3d(1, 1, c).asDiagonal() *
                          (response.linear() * Vector3d(1e-3, 2e-3, -3e-4 * c));
  EXPECT_LT((solution.resultants - linear).norm(), 1e-10 * linear.norm());
  EXPECT_EQ(solution.slip_area(), 0);
  EXPECT_EQ(solution.iterations, 1);
}

// Where nothing slips, the bound has no part in the solution.
TEST(SteadyPatch, DoesNotFeelABoundThatItDoesNotReach) {
  SteadyPatch problem = circle(8, rolling(1e-6, 2e-6, 1e-6));
  problem.bound = EllipticBound(1, 1, 1);
  const SteadyPatchSolution solution = solve_steady(problem);
  problem.bound = EllipticBound(1, 1, 1.9);
  const SteadyPatchSolution other = solve_steady(problem);
  ASSERT_EQ(solution.slip_area(), 0);
  EXPECT_LT((solution.resultants - other.resultants).norm(), 1e-10 * solution.resultants.norm());
}

TEST(SteadyPatch, SlidesAsAWholeUnderLargeCreepages) {
  for (const double ratio : {0.2, 1.0, 5.0}) {
    SteadyPatch problem = circle(7, rolling(3e5, -4e5, 0));
    problem.bound = EllipticBound(std::sqrt(ratio), 1 / std::sqrt(ratio), 1);
    const Vector3d resultants = relative(problem);
    EXPECT_NEAR(resultants[0], -0.6, 1e-6);
    EXPECT_NEAR(resultants[1], 0.8, 1e-6);
    EXPECT_NEAR(resultants[2], 0, 2e-3);  // the lever within a part of a cell
  }
}

TEST(SteadyPatch, TakesMotionsOfAnySize) {
  const Vector3d large = relative(circle(6, rolling(1e9, -2e9, 1e9)));
  const SteadyPatch problem = circle(6, rolling(1e40, -2e40, 1e40));
  const SteadyPatchSolution solution = solve_steady(problem);
  EXPECT_LT((relative(problem, solution) - large).norm(), 1e-8);
  EXPECT_EQ(solution.motion[0], 1e40);
  EXPECT_NEAR(solution.slip.rowwise().norm().maxCoeff(), 3e40, 1e40);
}

TEST(SteadyPatch, TurnsAboutTheCentreUnderLargeSpin) {
  for (const double ratio : {0.5, 1.0, 2.0}) {
    SteadyPatch problem = circle(14, rolling(0, 0, 1e6));
    problem.bound = EllipticBound(std::sqrt(ratio), 1 / std::sqrt(ratio), 1);
    const SteadyPatchSolution solution = solve_steady(problem);
    EXPECT_NEAR(solution.resultants[2], -problem.bound.turning_moment(), 2e-3) << ratio;
    EXPECT_LT(solution.force(), 1e-4 * problem.bound.total());
  }
}

// Mirrored in the plane of rolling, lateral forces, spin and moments change their signs.
TEST(SteadyPatch, IsMirroredInThePlaneOfRolling) {
  const Vector3d one = relative(circle(7, rolling(0.2, 0.1, 0.3)));
  const Vector3d other = relative(circle(7, rolling(0.2, -0.1, -0.3)));
  EXPECT_NEAR(one[0], other[0], 1e-9);
  EXPECT_NEAR(one[1], -other[1], 1e-9);
  EXPECT_NEAR(one[2], -other[2], 1e-9);
  const Vector3d reversed = relative(circle(7, rolling(-0.2, -0.1, -0.3)));
  EXPECT_LT((one + reversed).norm(), 1e-9);
}

TEST(SteadyPatch, HasResultantsInUnits) {
  const Vector3d one = relative(circle(6, rolling(0.2, 0.1, 0.3)));
  SteadyPatch scaled = circle(6, rolling(0.2 * 300 / 8e4, 0.1 * 300 / 8e4, 0.3 * 300 / 8e4 / 5));
  scaled.material.shear_modulus = 8e4;
  scaled.bound = EllipticBound(5, 5, 300);
  const SteadyPatchSolution solution = solve_steady(scaled);
  EXPECT_LT((relative(scaled, solution) - one).norm(), 1e-9);
  EXPECT_NEAR(solution.area.sum(), 25 * pi, 1e-9);
}

TEST(SteadyPatch, GivesTheMotionOfPrescribedResultants) {
  const SteadyPatch problem = circle(8, rolling(0.2, -0.3, 0.15));
  const SteadyPatchSolution solution = solve_steady(problem);
  for (int chosen = 1; chosen < 8; ++chosen) {
    SteadyPatch other = problem;
    for (int j = 0; j < 3; ++j) {
      if ((chosen >> j) % 2 == 0) continue;
      other.load[static_cast<std::size_t>(j)] = {true, solution.resultants[j]};
    }
    const SteadyPatchSolution found = solve_steady(other);
    EXPECT_LT((found.motion - solution.motion).norm(), 1e-7) << chosen;
    EXPECT_LT((found.resultants - solution.resultants).norm(), 1e-7) << chosen;
  }
}

// Each row of an ellipse that is narrow along the rolling is a line contact of Carter's. Their
// half-widths and peaks are cos(psi) times those of the middle.
TEST(SteadyPatch, IsCartersLineContactAcrossAWideEllipse) {
  const Material material{1, 0.3};
  SteadyPatch problem{.material = material,
                      .bound = EllipticBound(std::sqrt(1e-3), 1 / std::sqrt(1e-3), 1),
                      .rows = 20,
                      .elements = 20};
  for (const double creepage : {0.3, 0.7, 1.2}) {
    problem.load = rolling(creepage, 0, 0);
    double expected = 0, full = 0;
    constexpr int parts = 1000;
    for (int i = 0; i < parts; ++i) {
      const double cosine = std::cos(pi * ((i + 0.5) / parts - 0.5));
      const HertzBound row(cosine, cosine);
      expected += cosine * Carter::from_creepage(material, row, creepage).force();
      full += cosine * row.total();
    }
    EXPECT_NEAR(relative(problem)[0], expected / full, 2e-3) << creepage;
  }
}

TEST(SteadyPatch, HasASmallChangeWhereItIsAccurate) {
  const SteadyPatchSolution coarse = solve_steady_with_change(circle(4, rolling(0, 0, 2)));
  const SteadyPatchSolution fine = solve_steady_with_change(circle(16, rolling(0.3, 0.2, 0.1)));
  EXPECT_GT(coarse.evidence.change, 0.05);
  EXPECT_LT(fine.evidence.change, 5e-3);
  EXPECT_EQ(solve_steady_with_change(circle(2, rolling(1e-3, 0, 0))).evidence.change, 1);
  // A single row has a sixth more force than the bound.
  SteadyPatch one = circle(8, rolling(5, 0, 0));
  one.rows = 1;
  EXPECT_NEAR(solve_steady(one).evidence.bound_resolution(), 0.15, 0.01);
  EXPECT_EQ(solve_steady_with_change(one).evidence.change, 1);
}

TEST(SteadyPatch, RefusesBadNumbers) {
  const auto message = [](const SteadyPatch& problem) -> std::string {
    try {
      solve_steady(problem);
    } catch (const std::invalid_argument& error) {
      return error.what();
    } catch (const NotConverged& error) {
      return error.what();
    }
    return "";
  };
  using testing::StartsWith;
  SteadyPatch problem = circle(6, {{{true, 2.1}, {}, {}}});
  EXPECT_THAT(message(problem), StartsWith("force = 2.1: expected less than full sliding"));
  problem.load = {{{true, 1.6}, {true, -1.6}, {}}};
  EXPECT_THAT(message(problem), StartsWith("lateral_force = -1.6: expected forces whose vector"));
  problem.load = {{{}, {}, {true, 3}}};
  EXPECT_THAT(message(problem), StartsWith("spin_moment = 3: expected less than the moment"));
  problem.load = {{{true, 1.8}, {}, {true, 1.1}}};
  EXPECT_THAT(message(problem), StartsWith("stick and slip of the contact are found up to"));
  EXPECT_THAT(message(circle(1, rolling(1, 0, 0))), StartsWith("elements = 1: expected a whole"));
  problem.load = rolling(std::nan(""), 0, 0);
  EXPECT_THAT(message(problem), StartsWith("creepage = nan: expected"));
  EXPECT_THROW(EllipticBound(1, 0, 1), std::invalid_argument);
}

}  // namespace microslip::steady_patch_test
