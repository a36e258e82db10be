// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/inverted_rolling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/reference/carter.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"
#include "microslip/thesis/edge_displacement.hpp"
#include "stick_zones.hpp"

namespace microslip::inverted_rolling_test {

using Eigen::VectorXd;

const Material material{1.44, 0.28};  // compliance 1

TabulatedBound table(double half_width, const std::vector<double>& x,
                     const std::vector<double>& bound) {
  const auto n = static_cast<Eigen::Index>(x.size());
  return {half_width, Eigen::Map<const VectorXd>(x.data(), n),
          Eigen::Map<const VectorXd>(bound.data(), n)};
}

double creepage_of(const TractionBound& bound, double force) {
  return InvertedRolling(PlaneKernel(material, 7), bound).solve(PrescribedForce{force}).creepage();
}

// From next to full sliding to next to full adhesion.
TEST(InvertedRolling, IsCarter) {
  const HertzBound bound(2, 3);
  const PlaneKernel kernel(material, 200);
  const InvertedRolling rolling(kernel, bound);
  for (const double stick_ratio : {1e-3, 0.05, 0.3, 0.6, 0.98, 1 - 1e-6}) {
    const Carter carter = Carter::from_stick_ratio(material, bound, stick_ratio);
    const InvertedSolution by_force = rolling.solve(PrescribedForce{carter.force()});
    const InvertedSolution by_creepage = rolling.solve(PrescribedCreepage{carter.creepage()});
    EXPECT_NEAR(by_creepage.force() / carter.force(), 1, 1e-12);
    EXPECT_NEAR(by_force.creepage() / carter.creepage(), 1, 1e-12);
    EXPECT_NEAR(by_force.stick_edge(), 2 - 4 * stick_ratio, 1e-11);
    EXPECT_EQ(by_force.stick_end(), 2);
    for (int i = 0; i < 80; ++i) {
      const double x = -2 + (i + 0.5) / 20;
      EXPECT_NEAR(by_creepage.traction(x), carter.traction(x), 1e-12 * std::abs(carter.force()));
      EXPECT_NEAR(by_creepage.slip(x), carter.slip(x), 1e-10 * std::abs(carter.creepage()));
    }
    EXPECT_NEAR(by_force.displacement(VectorXd::Constant(1, 2))[0],
                edge_displacement(kernel, carter), 1e-10 * std::abs(carter.creepage()));
    EXPECT_EQ(rolling.solve(PrescribedForce{-carter.force()}).creepage(), -by_force.creepage());
  }
}

// Chebyshev's polynomials for what adhesion takes away from full sliding lose digits as the load
// vanishes.
TEST(InvertedRolling, AgreesWithChebyshevAtEveryPlace) {
  const PolynomialBound bound(1, 1, Eigen::Vector3d(1, 0.3, 0.2));
  const VectorXd x = VectorXd::LinSpaced(201, -0.999, 0.999);
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 20)),
        Kernel(StripKernel(material, 2)), Kernel(StripKernel(material, 1))}) {
    const InvertedRolling rolling(kernel, bound);
    const ChebyshevRolling reference(kernel, bound);
    for (const Load& load :
         {Load(PrescribedForce{-1}), Load(PrescribedForce{0.01}), Load(PrescribedForce{-1.6}),
          Load(PrescribedCreepage{0.4}), Load(PrescribedCreepage{9})}) {
      const InvertedSolution solution = rolling.solve(load);
      const ChebyshevSolution exact = reference.solve(load);
      const double force = std::abs(exact.force());
      const double creepage = std::abs(exact.creepage());
      EXPECT_NEAR(solution.force() / exact.force(), 1, 1e-11);
      EXPECT_NEAR(solution.creepage() / exact.creepage(), 1, 1e-11);
      const VectorXd u = solution.displacement(x);
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(solution.traction(x[i]), exact.traction(x[i]), 1e-9 * force) << x[i];
        EXPECT_NEAR(solution.slip(x[i]), exact.slip(x[i]), 1e-9 * creepage) << x[i];
        EXPECT_NEAR(u[i], exact.displacement(x[i]), 1e-9 * creepage) << x[i];
      }
      EXPECT_LE(solution.evidence().violation(), 1e-12);
    }
  }
}

// A fine table of a smooth bound; its kinks change the creepage by their distance squared.
TEST(InvertedRolling, TakesTables) {
  const HertzBound hertz(1, 1);
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 2))}) {
    const double exact = InvertedRolling(kernel, hertz).solve(PrescribedForce{-1}).creepage();
    double before = 0;
    for (const Eigen::Index rows : {101, 201, 401}) {
      const VectorXd x = -VectorXd::LinSpaced(rows, 0, 3.14159265358979312).array().cos();
      const TabulatedBound rough(1, x, bound_at(hertz, x));
      const InvertedSolution found = InvertedRolling(kernel, rough).solve(PrescribedForce{-1});
      const double error = std::abs(found.creepage() / exact - 1);
      if (before > 0) {
        EXPECT_NEAR(before / error, 4, 0.3) << rows;
      }
      EXPECT_LT(error, 1 / static_cast<double>(rows * rows));
      before = error;
    }
  }
}

// The bound inside the stick zone has no part in it.
TEST(InvertedRolling, DoesNotKnowTheBoundWhereItIsNotReached) {
  const double force = -0.1;
  const std::vector<double> x{-1, -0.6, -0.2, 0.2, 0.6, 1};
  const double expected = creepage_of(table(1, x, {0.1, 1, 1, 1, 1, 0.5}), force);
  for (const double inside : {0.5, 3.0, 1e3, 1e6}) {
    EXPECT_NEAR(creepage_of(table(1, x, {0.1, 1, inside, 1, inside, 0.5}), force) / expected, 1,
                1e-13);
  }
}

// More rows on its straight pieces are the same bound, next to its kinks as well.
TEST(InvertedRolling, DoesNotKnowRowsOnStraightPieces) {
  const std::vector<double> x{-1, -0.9, -0.5, -0.3, 0.4, 1};
  const std::vector<double> bound{0.1, 0.4, 0.45, 0.8, 1, 0};
  std::vector<double> more_x, more_bound;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (const double part : {0.0, 0.1, 0.13, 0.5, 0.9}) {
      more_x.push_back(x[i] + part * (x[i + 1] - x[i]));
      more_bound.push_back(bound[i] + part * (bound[i + 1] - bound[i]));
    }
  }
  more_x.push_back(x.back());
  more_bound.push_back(bound.back());
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 2))}) {
    for (const double force : {-0.9, -0.5, -0.05}) {
      const Load load = PrescribedForce{force};
      const InvertedSolution few = InvertedRolling(kernel, table(1, x, bound)).solve(load);
      const InvertedSolution many =
          InvertedRolling(kernel, table(1, more_x, more_bound)).solve(load);
      EXPECT_NEAR(few.creepage() / many.creepage(), 1, 1e-12);
      for (int i = 0; i < 400; ++i) {
        const double at = -1 + (i + 0.5) / 200;
        EXPECT_NEAR(few.traction(at), many.traction(at), 1e-11) << at;
        EXPECT_NEAR(few.slip(at), many.slip(at), 1e-11) << at;
      }
    }
  }
}

// Roughness of a smooth bound that keeps its slip zone.
TEST(InvertedRolling, DoesNotKnowARoughBoundWhereItIsNotReached) {
  const HertzBound hertz(5, 300);
  const VectorXd x = VectorXd::LinSpaced(201, -5, 5);
  VectorXd bound = bound_at(hertz, x);
  const double force = -1e-3 * hertz.total();
  const double expected = creepage_of(TabulatedBound(5, x, bound), force);
  for (Eigen::Index i = 20; i < 180; ++i) bound[i] *= i % 3 == 0 ? 1.5 : 0.6;
  EXPECT_NEAR(creepage_of(TabulatedBound(5, x, bound), force) / expected, 1, 1e-13);
}

// With k = 2 (1 - nu)/(pi G), everything sticks if the load is small: w = -k F/a. Whatever is the
// bound, which ends at the edges here, or is zero before or behind them, or has a step.
TEST(InvertedRolling, TendsToTheLimitOfFullAdhesion) {
  const double k = 1 / 3.14159265358979312;
  for (const TabulatedBound& bound :
       {table(5, {-5, 0, 0.001, 5}, {100, 100, 200, 0}), table(5, {-5, 5}, {100, 100}),
        table(5, {-5, 5}, {0, 100}), table(5, {-5, 5}, {100, 0})}) {
    for (const double part : {1e-6, 1e-9}) {
      const double force = -part * bound.total();
      const double limit = -k * force / 5;
      EXPECT_NEAR(creepage_of(bound, force) / limit, 1, 200 * std::pow(part, 2. / 3)) << part;
    }
  }
  const TabulatedBound shorter = table(5, {-5, -3, 0, 3, 5}, {0, 0, 100, 0, 0});
  const double force = -1e-9 * shorter.total();
  EXPECT_NEAR(creepage_of(shorter, force) / (-k * force / 3), 1, 1e-5);
}

// A bound that falls to zero at the leading edge as a straight line slips there, too: what leaves
// the bound at the leading end of adhesion does so with the power 3/2.
TEST(InvertedRolling, SlipsBeforeTheStickZoneWhereTheBoundFallsFast) {
  const TabulatedBound bound = table(1, {-1, 0, 1}, {0, 1, 0});
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 2))}) {
    for (const double part : {0.01, 0.3, 0.9}) {
      const InvertedSolution found =
          InvertedRolling(kernel, bound).solve(PrescribedForce{-part * bound.total()});
      EXPECT_LT(found.stick_end(), 1);
      EXPECT_LE(found.evidence().violation(), 1e-12);
      EXPECT_NEAR(found.evidence().dissipation_error(), 0, 1e-2);
      const double c = found.stick_end();
      const auto below = [&](double x) { return bound(x) + found.traction(x); };
      const double near = 1e-3 * (1 - c);
      EXPECT_NEAR(below(c - 4 * near) / below(c - near), 8, 0.1);
    }
  }
}

// Forces and creepages lead to each other.
TEST(InvertedRolling, IsTheSameByForceAndByCreepage) {
  const TabulatedBound bound = table(1, {-1, -0.3, 0.4, 1}, {0.2, 0.5, 1, 0});
  const InvertedRolling rolling(StripKernel(material, 2), bound);
  for (const double part : {1e-6, 1e-3, 0.5, 0.99}) {
    const double force = -part * bound.total();
    const double creepage = rolling.solve(PrescribedForce{force}).creepage();
    EXPECT_NEAR(rolling.solve(PrescribedCreepage{creepage}).force() / force, 1, 1e-10);
  }
}

TEST(InvertedRolling, RefusesForcesOfFullSliding) {
  const InvertedRolling rolling(PlaneKernel(material, 1), HertzBound(1, 1));
  EXPECT_THROW(rolling.solve(PrescribedForce{-2}), std::invalid_argument);
  EXPECT_THROW(rolling.solve(PrescribedCreepage{NAN}), std::invalid_argument);
}

SteadyProblem problem(const TractionBound& bound, Load load, Eigen::Index n = 100) {
  return {.contact = {PlaneKernel(material, 7), bound},
          .grid = Grid({.half_width = 1, .elements = n}),
          .load = load};
}

TEST(Inversion, TellsWhereItSticks) {
  const SteadySolution s = solve_steady(problem(HertzBound(1, 1), PrescribedCreepage{0.4}));
  EXPECT_NEAR(s.stick_edge.value(), -0.2, 1e-12);
  for (Eigen::Index i = 0; i < 100; ++i) {
    EXPECT_EQ(s.zones[static_cast<std::size_t>(i)] == Zone::adhesion, s.x[i] >= *s.stick_edge);
  }
  SteadyProblem differences = problem(HertzBound(1, 1), PrescribedCreepage{0.4});
  differences.method = Differences{};
  EXPECT_FALSE(solve_steady(differences).stick_edge.has_value());
}

TEST(Inversion, DoesNotDependOnTheGridsAlignment) {
  const SteadyProblem half = problem(HertzBound(1, 1), PrescribedCreepage{0.4});
  SteadyProblem other = half;
  other.grid =
      Grid({.half_width = 1, .elements = 100, .leading_offset = 0.05, .trailing_offset = 0.9});
  EXPECT_EQ(solve_steady(half).force, solve_steady(other).force);
}

TEST(Inversion, IsZeroWithoutALoad) {
  const SteadySolution rest = solve_steady(problem(HertzBound(1, 1), PrescribedForce{0}));
  EXPECT_EQ(rest.creepage, 0);
  EXPECT_EQ(rest.traction.lpNorm<Eigen::Infinity>(), 0);
  EXPECT_EQ(rest.slip.lpNorm<Eigen::Infinity>(), 0);
  EXPECT_FALSE(std::signbit(rest.traction[0]));  // or a table would say -0
}

// Its nodes only say where the result is wanted.
TEST(Inversion, IsTheSameWithAnyNumberOfElements) {
  const PolynomialBound bound(1, 1, Eigen::Vector3d(1, 0.3, 0.2));
  const Load load = PrescribedForce{-0.8};
  const double exact = solve_steady(problem(bound, load, 1000)).creepage;
  for (const Eigen::Index n : {1, 2, 3, 5, 10, 100}) {
    EXPECT_EQ(solve_steady(problem(bound, load, n)).creepage, exact);
  }
}

// A bound with a dent slips there, too. The difference scheme knows nothing of zones.
TEST(Inversion, TakesSeveralStickZones) {
  const PolynomialBound dented(1, 1, (Eigen::VectorXd(3) << 0.05, 0, 1).finished());
  for (const double direction : {1, -1}) {
    const Load load = PrescribedForce{direction * 0.5 * dented.total()};
    const SteadySolution s = solve_steady(problem(dented, load, 400));
    EXPECT_EQ(stick_zones(s.zones), 2);
    EXPECT_EQ(s.scheme, SteadyScheme::inversion);
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

// The strain of full sliding is largest inside the contact, under a hump: there the bodies still
// stick under creepages at which one zone at the leading edge would slide.
TEST(Inversion, SlidesFullyWhereNoHumpSticks) {
  for (const double place : {-0.5, 0.5}) {
    const PolynomialBound humps(1, 1, Eigen::Vector3d(place * place + 0.03, -2 * place, 1));
    for (const double part : {0.5, 0.7, 0.8, 0.9, 0.95, 0.98}) {
      const double force = -part * humps.total();
      const double creepage = solve_steady(problem(humps, PrescribedForce{force}, 400)).creepage;
      const SteadySolution s = solve_steady(problem(humps, PrescribedCreepage{creepage}, 400));
      EXPECT_NEAR(s.force / force, 1, 0.003) << place << ' ' << part;
    }
  }
}

// Next to the load at which the dent begins to slip; there the dent's zone is short, and what one
// stick zone would have above the bound is less than a hundredth of the peak.
TEST(Inversion, SeesASecondSlipZoneWhileItIsShort) {
  const PolynomialBound dented(1, 1, (Eigen::VectorXd(3) << 0.05, 0, 1).finished());
  for (const double part : {0.32, 0.33, 0.35}) {
    const SteadySolution s =
        solve_steady(problem(dented, PrescribedForce{-part * dented.total()}, 400));
    EXPECT_EQ(stick_zones(s.zones), 2) << part;
    EXPECT_LE((s.traction.cwiseAbs() - s.bound).maxCoeff(), 1e-5) << part;
  }
}

TEST(Inversion, NeedsFewEvaluations) {
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 7)), Kernel(StripKernel(material, 2))}) {
    const PolynomialBound bound(1, 1, Eigen::Vector3d(1, 0.3, 0.2));
    for (const Load& load : {Load(PrescribedForce{-0.9}), Load(PrescribedForce{0.4})}) {
      EXPECT_LE(InvertedRolling(kernel, bound).solve(load).evaluations(), 30);
    }
  }
}

}  // namespace microslip::inverted_rolling_test
