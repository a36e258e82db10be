// SPDX-License-Identifier: GPL-3.0-or-later
// The standard scheme in three dimensions against the program that has it, and against itself.
#include "microslip/patch/standard_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/support/not_converged.hpp"

namespace microslip::standard_patch_test {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixX2d;
using Eigen::Vector3d;
using std::numbers::pi;

PatchLoad motion(const Vector3d& of) { return {{{false, of[0]}, {false, of[1]}, {false, of[2]}}}; }

/// The ellipse of the runs of CONTACT v25.2: a = 1 mm, G = 1 N/mm^2, nu = 0.28, mu Fn = 0.3 N.
StandardPatch contacts(double ratio, Index size) {
  return {.material = {1, 0.28},
          .bound = EllipticBound(1, 1 / ratio, 0.45 * ratio / pi),
          .elements = size,
          .rows = size};
}

StandardPatch circle(Index size) {
  return {.material = {1, 0.25}, .bound = EllipticBound(1, 1, 1), .elements = size, .rows = size};
}

Index slipping(const RectangleRolling& rolling) {
  return std::ranges::count(rolling.slips(), true);
}

// CONTACT v25.2, T = 3, B = 0, solver GDsteady with a tolerance of 1e-8: Fx, Fy, Mz, the number of
// elements that slip, and the printed friction power over the velocity. Forces agree to 2e-9 of
// mu Fn, which is what CONTACT's iterations leave.
TEST(StandardPatch, HasContactsResultsInSteadyRolling) {
  const struct {
    double ratio;
    Index size;
    Vector3d motion, resultants;
    Index slipping;
    double dissipation;
  } cases[] = {
      {1, 20, {0.07, 0, 0}, {-0.219412088914, 0, 0}, 156, 0.0135215358562},
      {1, 20, {0, 0.16, 0}, {0, -0.295370719521, 0.00925296066399}, 286, 0.0443114036352},
      {1, 20, {0, 0, 0.1}, {0, -0.135327089913, -0.081695236678}, 148, 0.00670874823824},
      {1, 20, {0, 0, 0.4}, {0, -0.130986700977, -0.14725148128}, 314, 0.0557286280001},
      {2, 20, {0.11, 0, 0}, {-0.214236930376, 0, 0}, 156, 0.0205665490951},
      {2, 20, {0, 0, 0.62}, {0, -0.173706057377, -0.0926988058876}, 314, 0.0521734707179},
      {1, 28, {0, 0, 0.1}, {0, -0.135327084609, -0.0808533618716}, 298, 0.00701634482508},
      {2, 28, {0, 0.24, 0}, {0, -0.294202809237, 0.00661407977246}, 542, 0.0673438282896},
      {1, 40, {0.07, 0, 0}, {-0.217231565873, 0, 0}, 634, 0.0142713936097},
  };
  for (const auto& one : cases) {
    RectangleRolling rolling(contacts(one.ratio, one.size));
    rolling.roll_steadily(motion(one.motion));
    const Vector3d error = rolling.resultants() - one.resultants;
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 4e-9 * 0.3) << one.ratio << ' ' << one.size;
    EXPECT_EQ(slipping(rolling), one.slipping);
    EXPECT_NEAR(rolling.dissipation(), one.dissipation, 1e-8 * 0.3);
  }
}

// CONTACT v25.2, T = 1, then T = 2 with Fx = -0.6 mu Fn held, N = 20, tolerance 1e-7: the shift
// [mm], then the creepage of a step, and the number of elements that slip.
TEST(StandardPatch, HasContactsCreepagesAfterAShift) {
  const struct {
    double step;  ///< over an element
    int number;
    double creepage;
    Index slipping;
  } states[] = {{1, 1, 0.031308707578, 88},    {1, 2, 0.0326852154663, 86},
                {1, 5, 0.0384812944864, 94},   {1, 15, 0.0534138258304, 120},
                {0.5, 1, 0.0300680514724, 88}, {0.5, 10, 0.0392031304809, 96},
                {0.1, 1, 0.0246645099176, 90}, {0.1, 2, 0.0251681857397, 90}};
  const PatchLoad held{{{true, -0.18}, {}, {}}};
  for (const double step : {1.0, 0.5, 0.1}) {
    RectangleRolling rolling(contacts(1, 20));
    rolling.shift(held);
    EXPECT_NEAR(rolling.motion()[0], 0.0883594083873, 5e-10);
    EXPECT_EQ(slipping(rolling), 140);
    EXPECT_NEAR(rolling.dissipation(), 7.862231538e-4, 1e-9);
    int rolled = 0;
    for (const auto& state : states) {
      if (state.step != step) continue;
      for (; rolled < state.number; ++rolled) rolling.roll(step * 0.1, held);
      EXPECT_NEAR(rolling.motion()[0], state.creepage, 4e-7) << step << ' ' << state.number;
      EXPECT_EQ(slipping(rolling), state.slipping) << step << ' ' << state.number;
    }
    if (step < 1) continue;
    // Tractions after 15 steps at (-0.75, -0.55), (0.05, -0.55) and (-0.25, 0.25).
    const struct {
      double x, y, along, across;
    } tractions[] = {{-0.75, -0.55, -5.336299404038945e-2, 5.097217096154785e-3},
                     {0.05, -0.55, -4.989033874492947e-2, 1.560595953361539e-3},
                     {-0.25, 0.25, -7.972736053108610e-2, -1.099811283317718e-3}};
    const MatrixX2d found = rolling.tractions();
    for (const auto& [x, y, along, across] : tractions) {
      Index at = 0;
      ((rolling.x().array() - x).square() + (rolling.y().array() - y).square()).minCoeff(&at);
      EXPECT_NEAR(rolling.x()[at], x, 1e-12);
      EXPECT_NEAR(found(at, 0), along, 5e-8);
      EXPECT_NEAR(found(at, 1), across, 5e-8);
    }
  }
}

// CONTACT v25.2, T = 2 with a spin of 0.1/mm from rest: Fy over mu Fn, to the digits that were
// noted.
TEST(StandardPatch, HasContactsLateralForceAfterSpinFromRest) {
  RectangleRolling rolling(contacts(1, 20));
  for (const double expected : {-0.0516, -0.1635, -0.2745}) {  // after 0.5, 1 and 1.5 mm
    for (int i = 0; i < 5; ++i) rolling.roll(0.1, motion({0, 0, 0.1}));
    EXPECT_NEAR(rolling.resultants()[1] / 0.3, expected, 6e-5);
  }
}

TEST(StandardPatch, IsLinearUnderSmallLoads) {
  const StandardPatch problem{.material = {80000, 0.3},
                              .bound = EllipticBound(6, 3, 1e4),
                              .elements = 12,
                              .rows = 9,
                              .pressure = StandardPatch::Pressure::hertz};
  const Matrix3d linear = linear_response(Rectangles::in_ellipse(6, 3, 12, 9), 0.3);
  RectangleRolling rolling(problem);
  const Vector3d small(1e-3, 2e-3, -3e-4);
  rolling.roll_steadily(motion(small));
  EXPECT_EQ(slipping(rolling), 0);
  const Vector3d expected = 8e4 * linear * small;
  EXPECT_LT((rolling.resultants() - expected).norm(), 1e-7 * expected.norm());
}

// CONTACT v25.2, T = 3, N = 20, nu = 0.28, nothing slips: C11, C22, C23, C32 and C33 to ten digits.
// Steps follow tractions that nearly fulfil their conditions: without a load there are none.
TEST(StandardPatch, IsLinearUnderSmallLoadsInSteps) {
  const auto force = [](double size) {
    RectangleRolling rolling(circle(10));
    for (int i = 0; i < 4; ++i) rolling.roll(0.2, motion({size, 0, size}));
    return rolling.resultants()[0] / size;
  };
  for (const double size : {1e-90, 1e-12, 1e-6}) {
    EXPECT_NEAR(force(size) / force(1e-3), 1, 1e-3) << size;
  }
}

TEST(StandardPatch, HasContactsCreepCoefficients) {
  const Matrix3d linear = linear_response(Rectangles::in_ellipse(1, 1, 20, 20), 0.28);
  EXPECT_NEAR(-linear(0, 0), 4.30558615, 4e-9);
  EXPECT_NEAR(-linear(1, 1), 3.7914249172, 4e-9);
  EXPECT_NEAR(-linear(1, 2), 1.5134575703, 4e-9);
  EXPECT_NEAR(linear(2, 1), 1.4502671536, 4e-9);
  EXPECT_NEAR(-linear(2, 2), 1.2679622657, 4e-9);
}

// Mirrored in the plane of rolling, lateral forces, spin and moments change their signs.
TEST(StandardPatch, IsMirroredInThePlaneOfRolling) {
  RectangleRolling rolling(circle(11));
  const auto results = [&](const Vector3d& of, bool steady) -> Vector3d {
    if (steady) {
      rolling.roll_steadily(motion(of));
    } else {
      rolling = RectangleRolling(circle(11));
      rolling.shift(motion(of / 3));
      rolling.roll(0.13, motion(of));
    }
    return rolling.resultants();
  };
  for (const bool steady : {true, false}) {
    const Vector3d one = results({0.2, 0.1, 0.3}, steady);
    const Vector3d other = results({0.2, -0.1, -0.3}, steady);
    EXPECT_LT((one - Vector3d(1, -1, -1).cwiseProduct(other)).norm(), 1e-8);
    EXPECT_LT((one + results({-0.2, -0.1, -0.3}, steady)).norm(), 1e-8);
  }
}

TEST(StandardPatch, GivesTheMotionOfPrescribedResultants) {
  for (const bool steady : {true, false}) {
    RectangleRolling one(circle(9));
    const auto go = [&](RectangleRolling& rolling, const PatchLoad& load) {
      rolling.shift(motion({0.1, 0, 0}));
      steady ? rolling.roll_steadily(load) : rolling.roll(0.3, load);
    };
    const Vector3d given(0.2, -0.3, 0.15);
    go(one, motion(given));
    ASSERT_GT(slipping(one), 0);
    ASSERT_LT(slipping(one), one.size());
    for (int chosen = 1; chosen < 8; ++chosen) {
      PatchLoad load = motion(given);
      for (int j = 0; j < 3; ++j) {
        if ((chosen >> j) % 2 == 1) load[static_cast<std::size_t>(j)] = {true, one.resultants()[j]};
      }
      RectangleRolling other(circle(9));
      go(other, load);
      EXPECT_LT((other.motion() - given).norm(), 1e-7) << chosen;
      EXPECT_LT((other.tractions() - one.tractions()).cwiseAbs().maxCoeff(), 1e-7) << chosen;
    }
  }
}

TEST(StandardPatch, StaysInASteadyState) {
  RectangleRolling rolling(circle(10));
  const PatchLoad load = motion({0.2, 0.1, 0.5});
  rolling.roll_steadily(load);
  const MatrixX2d steady = rolling.tractions(), slip = rolling.slip();
  rolling.roll(rolling.element(), load);
  EXPECT_LT((rolling.tractions() - steady).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((rolling.slip() - slip).cwiseAbs().maxCoeff(), 1e-7);
}

// Where it sticks nothing slips, and elsewhere tractions have the bound and the direction of the
// slip.
TEST(StandardPatch, FulfilsCoulombsLaw) {
  RectangleRolling rolling(circle(12));
  rolling.roll_steadily({{{true, 0.5}, {false, 0.1}, {false, 1}}});
  const MatrixX2d tractions = rolling.tractions(), slip = rolling.slip();
  for (Index i = 0; i < rolling.size(); ++i) {
    const double bound = rolling.bound()[i], size = slip.row(i).norm();
    if (rolling.slips()[static_cast<std::size_t>(i)]) {
      EXPECT_LT((tractions.row(i) + bound / size * slip.row(i)).norm(), 1e-7);
    } else {
      EXPECT_EQ(size, 0);
      EXPECT_LE(tractions.row(i).norm(), bound);
    }
  }
  EXPECT_EQ(rolling.resultants()[0], 0.5);
  EXPECT_LT(rolling.residual(), 1e-9);
}

// Cattaneo and Mindlin: at nu = 0, F = full (1 - k^3) by the shift mu p0/2G (1 - k^2) pi a.
TEST(StandardPatch, IsShiftedAfterCattaneoAndMindlin) {
  StandardPatch problem = circle(24);
  problem.material.poisson_ratio = 0;
  RectangleRolling rolling(problem);
  const double k = 0.7, full = 2 * pi / 3;
  rolling.shift({{{}, {true, -full * (1 - k * k * k)}, {}}});
  EXPECT_NEAR(rolling.motion()[1] / (pi / 2 * (1 - k * k)), 1, 2e-3);
  EXPECT_NEAR(1 - static_cast<double>(slipping(rolling)) * rolling.area() / pi, k * k,
              0.05);  // a ring of elements has 0.11
  // Tractions have the direction of the force.
  EXPECT_LT(rolling.tractions().col(0).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(StandardPatch, HasResultantsInUnits) {
  RectangleRolling one(circle(8));
  one.shift(motion({0.2, 0.1, 0.3}));
  one.roll(0.2, motion({0.2, 0.1, 0.3}));
  StandardPatch scaled = circle(8);
  const double strain = 300 / 8e4;
  scaled.material.shear_modulus = 8e4;
  scaled.bound = EllipticBound(5, 5, 300);
  RectangleRolling other(scaled);
  other.shift(motion(strain * Vector3d(5 * 0.2, 5 * 0.1, 0.3)));
  other.roll(1, motion(strain * Vector3d(0.2, 0.1, 0.3 / 5)));
  const Vector3d units = 300 * 25 * Vector3d(1, 1, 5);
  EXPECT_LT((other.resultants().cwiseQuotient(units) - one.resultants()).norm(), 1e-8);
  EXPECT_LT((other.slip() / strain - one.slip()).norm(), 1e-7);
  EXPECT_NEAR(other.dissipation() / (300 * 25 * strain), one.dissipation(), 1e-8);
}

TEST(StandardPatch, RefusesBadNumbersAndStaysAsItWas) {
  RectangleRolling rolling(circle(8));
  rolling.roll_steadily(motion({0.2, 0.1, 0.3}));
  const Vector3d before = rolling.resultants();
  EXPECT_THROW(rolling.roll(0, motion({0, 0, 0})), std::invalid_argument);
  EXPECT_THROW(rolling.roll(0.1, motion({std::nan(""), 0, 0})), std::invalid_argument);
  EXPECT_THROW(rolling.roll(0.1, motion({1e300, 0, 0})), std::invalid_argument);
  EXPECT_THROW(rolling.roll_steadily(motion({0, 0, 1e-300})), std::invalid_argument);
  EXPECT_THROW(rolling.shift({{{true, 2.1}, {}, {}}}), std::invalid_argument);
  EXPECT_THROW(rolling.roll_steadily({{{true, 1.8}, {}, {true, 1.1}}}), NotConverged);
  EXPECT_EQ(rolling.resultants(), before);
  StandardPatch bad = circle(0);
  EXPECT_THROW(RectangleRolling{bad}, std::invalid_argument);
  bad = circle(5);
  bad.material.poisson_ratio = 0.6;
  EXPECT_THROW(RectangleRolling{bad}, std::invalid_argument);
}

}  // namespace microslip::standard_patch_test
