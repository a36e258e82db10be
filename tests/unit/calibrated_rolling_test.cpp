// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/calibrated_rolling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/reference/carter.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/spectrum/leading_edge.hpp"
#include "microslip/support/work.hpp"
#include "stick_zones.hpp"

namespace microslip {
namespace {

const Material material{1.44, 0.28};  // compliance 1

// The limits are those of Wiener-Hopf theory.
TEST(EdgeCalibration, TendsToThatOfTheUnboundedGrid) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const double limit = leading_edge_constants(basis).offset;
    const double coarse = edge_calibration(basis, 100).offset - limit;
    const double fine = edge_calibration(basis, 400).offset - limit;
    EXPECT_LT(std::abs(fine), 2e-4);
    EXPECT_NEAR(coarse / fine, 4, 0.05);  // first order
  }
}

TEST(CalibratedRolling, HasCartersForceAndTractionsWithFewElements) {
  const HertzBound bound(2, 3);
  for (const Basis& basis : {constant_basis(), linear_basis(), quadratic_basis()}) {
    CalibratedRolling rolling(PlaneKernel(material, 1), bound, basis, 7);
    for (const double stick_ratio : {0.05, 0.6, 0.98}) {
      const Carter carter = Carter::from_stick_ratio(material, bound, stick_ratio);
      const CalibratedSolution solution = rolling.solve(PrescribedCreepage{carter.creepage()});
      EXPECT_NEAR(solution.force() / carter.force(), 1, 1e-12);
      EXPECT_NEAR(solution.stick_edge(), 2 - 4 * stick_ratio, 1e-12);
      EXPECT_LT(solution.evidence().bound_violation(), 1e-12);
      EXPECT_LT(solution.evidence().slip_violation(), 1e-12);
      for (const double x : {-1.9, 0.1, 1.7, 1.99}) {
        EXPECT_NEAR(solution.traction(x), carter.traction(x), 1e-10) << x;
      }
    }
  }
}

TEST(CalibratedRolling, IsCarterNextToAdhesionEverywhere) {
  const HertzBound bound(2, 3);
  CalibratedRolling rolling(PlaneKernel(material, 1), bound, constant_basis(), 7);
  for (const double size : {1e-4, 1e-5, 1e-6}) {
    const Carter carter = Carter::from_creepage(material, bound, size * bound.peak());
    const double rounding = 2e-15 / size;
    EXPECT_NEAR(rolling.solve(PrescribedCreepage{carter.creepage()}).force() / carter.force(), 1,
                rounding);
    EXPECT_NEAR(rolling.solve(PrescribedForce{carter.force()}).creepage() / carter.creepage(), 1,
                rounding);
  }
}

// Within an element of the stick-slip point line loads are no picture of the elements: the slip is
// taken as a square root there.
TEST(CalibratedRolling, SlipIsCartersUpToTheStickSlipPoint) {
  const HertzBound bound(1, 1);
  CalibratedRolling rolling(PlaneKernel(material, 1), bound, constant_basis(), 100);
  const Carter carter = Carter::from_stick_ratio(material, bound, 0.6);
  const CalibratedSolution solution = rolling.solve(PrescribedCreepage{carter.creepage()});
  for (double elements = 0.05; elements < 4; elements += 0.05) {
    const double x = solution.stick_edge() - elements * 0.012;
    EXPECT_NEAR(solution.slip(x) / carter.slip(x), 1, 0.025) << elements;
  }
}

TEST(CalibratedRolling, AgreesWithChebyshevAtEveryPlace) {
  const PolynomialBound bound(1, 1, (Eigen::VectorXd(3) << 1, 0.3, 0.2).finished());
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 2))}) {
    CalibratedRolling rolling(kernel, bound, constant_basis(), 100);
    const ChebyshevRolling reference(kernel, bound);
    for (const Load& load : {Load(PrescribedForce{-1}), Load(PrescribedForce{1}),
                             Load(PrescribedCreepage{0.4}), Load(PrescribedCreepage{2})}) {
      const CalibratedSolution solution = rolling.solve(load);
      const ChebyshevSolution exact = reference.solve(load);
      EXPECT_NEAR(solution.force(), exact.force(), 1e-4);
      EXPECT_NEAR(solution.creepage(), exact.creepage(), 1e-4);
      EXPECT_NEAR(solution.dissipation(), exact.dissipation(), 1e-4);
      for (int i = 0; i <= 60; ++i) {
        const double x = -1 + i / 30.0;
        const double near = std::abs(x - exact.stick_edge()) < 0.1 || x > 0.95 ? 10 : 1;
        EXPECT_NEAR(solution.traction(x), exact.traction(x), near * 1e-3) << x;
        EXPECT_NEAR(solution.slip(x), exact.slip(x), near * 3e-3) << x;
        EXPECT_NEAR(solution.displacement(x), exact.displacement(x), 3e-4) << x;
      }
    }
  }
}

SteadyProblem problem(const TractionBound& bound, Load load, Eigen::Index n = 100) {
  return {.kernel = PlaneKernel(material, 7),
          .bound = bound,
          .grid = Grid({.half_width = 1, .elements = n}),
          .load = load};
}

TEST(Calibrated, TellsWhereItSticks) {
  const SteadySolution s = solve_steady(problem(HertzBound(1, 1), PrescribedCreepage{0.4}));
  EXPECT_NEAR(s.stick_edge.value(), -0.2, 1e-12);
  for (Eigen::Index i = 0; i < 100; ++i) {
    EXPECT_EQ(s.zones[static_cast<std::size_t>(i)] == Zone::adhesion, s.x[i] >= *s.stick_edge);
  }
  SteadyProblem differences = problem(HertzBound(1, 1), PrescribedCreepage{0.4});
  differences.method = Differences{};
  EXPECT_FALSE(solve_steady(differences).stick_edge.has_value());
}

TEST(Calibrated, DoesNotDependOnTheGridsAlignment) {
  const SteadyProblem half = problem(HertzBound(1, 1), PrescribedCreepage{0.4});
  SteadyProblem other = half;
  other.grid =
      Grid({.half_width = 1, .elements = 100, .leading_offset = 0.05, .trailing_offset = 0.9});
  EXPECT_EQ(solve_steady(half).force, solve_steady(other).force);
}

TEST(Calibrated, IsLinearInLoadsBelowAdhesionEverywhere) {
  const PolynomialBound bound(1, 1, (Eigen::VectorXd(3) << 1, 0.3, 0.2).finished());
  const SteadySolution s = solve_steady(problem(bound, PrescribedCreepage{1e-7}));
  const SteadySolution t = solve_steady(problem(bound, PrescribedCreepage{2e-7}));
  EXPECT_NEAR(t.force / s.force, 2, 1e-3);
  EXPECT_LT(s.force, 0);
  const SteadySolution rest = solve_steady(problem(bound, PrescribedForce{0}));
  EXPECT_EQ(rest.creepage, 0);
  EXPECT_EQ(rest.traction.lpNorm<Eigen::Infinity>(), 0);
}

// Tables are solved over the whole contact, at nodes of its own; many rows make them as good as
// smooth.
TEST(Calibrated, TakesTabulatedBounds) {
  const HertzBound hertz(1, 1);
  const Eigen::VectorXd angles = Eigen::VectorXd::LinSpaced(401, -3.14159265358979312, 0);
  const Eigen::VectorXd x = angles.array().cos();
  const TabulatedBound table(1, x, bound_at(hertz, x));
  const SteadySolution smooth = solve_steady(problem(hertz, PrescribedForce{-1}));
  const SteadySolution tabulated = solve_steady(problem(table, PrescribedForce{-1}));
  EXPECT_NEAR(tabulated.creepage, smooth.creepage, 2e-4);
  EXPECT_EQ(tabulated.scheme, SteadyScheme::whole_contact);
  EXPECT_EQ(tabulated.fallback, "the bound is a table");
  EXPECT_EQ(smooth.scheme, SteadyScheme::calibrated);
  EXPECT_EQ(smooth.fallback, "");
}

// A bound with a dent slips there, too. The difference scheme knows nothing of zones.
TEST(Calibrated, TakesSeveralStickZones) {
  const PolynomialBound dented(1, 1, (Eigen::VectorXd(3) << 0.05, 0, 1).finished());
  for (const double direction : {1, -1}) {
    const Load load = PrescribedForce{direction * 0.5 * dented.total()};
    const SteadySolution s = solve_steady(problem(dented, load, 400));
    EXPECT_EQ(stick_zones(s.zones), 2);
    EXPECT_NEAR(s.force, direction * 0.5 * dented.total(), 1e-12);
    SteadyProblem fine = problem(dented, load, 800);
    fine.method = Differences{};
    const SteadySolution expected = solve_steady(fine);
    EXPECT_NEAR(s.creepage / expected.creepage, 1, 3e-3);
    EXPECT_NEAR(s.traction[100], (expected.traction[200] + expected.traction[201]) / 2, 3e-3);
    EXPECT_NEAR(s.slip[200], (expected.slip[400] + expected.slip[401]) / 2, 2e-3);
    EXPECT_NEAR(s.displacement[100], (expected.displacement[200] + expected.displacement[201]) / 2,
                2e-3);
  }
}

// Next to the load at which the dent begins to slip; there the dent's zone is short, and what one
// stick zone would have above the bound is less than a hundredth of the peak.
TEST(Calibrated, SeesASecondSlipZoneWhileItIsShort) {
  const PolynomialBound dented(1, 1, (Eigen::VectorXd(3) << 0.05, 0, 1).finished());
  for (const double part : {0.32, 0.33, 0.35}) {
    const SteadySolution s =
        solve_steady(problem(dented, PrescribedForce{-part * dented.total()}, 400));
    EXPECT_EQ(stick_zones(s.zones), 2) << part;
    EXPECT_LE((s.traction.cwiseAbs() - s.bound).maxCoeff(), 1e-5) << part;
  }
}

// Fields behind many elements are interpolated: sums over all of them at each place would make it
// three times as many.
TEST(Calibrated, WorkAnElementHardlyGrowsWithTheirNumber) {
  const auto work = [](Eigen::Index n) {
    SteadyProblem strip = problem(HertzBound(1, 1), PrescribedForce{-1}, n);
    strip.kernel = StripKernel(material, 2);
    const WorkCount count;
    solve_steady(strip);
    return count.operations() / static_cast<double>(n);
  };
  EXPECT_LT(work(4000), 2 * work(500));
}

// A lattice of few elements finds the stick zone first: without it, there would be eight.
TEST(Calibrated, NeedsFewEvaluationsWithManyElements) {
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 2))}) {
    for (const Load& load : {Load(PrescribedForce{-0.9}), Load(PrescribedForce{0.4})}) {
      SteadyProblem many = problem(HertzBound(1, 1), load, 2000);
      many.kernel = kernel;
      EXPECT_LE(solve_steady(many).iterations, 6);
    }
  }
}

}  // namespace
}  // namespace microslip
