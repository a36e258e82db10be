// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/chebyshev_rolling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/reference/carter.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/thesis/edge_displacement.hpp"

namespace microslip::chebyshev_rolling_test {

const Material material{1.44, 0.28};  // compliance 1

PolynomialBound some_bound(double half_width = 1, double peak = 1) {
  return {half_width, peak, (Eigen::VectorXd(3) << 1, 0.3, 0.2).finished()};
}

TEST(ChebyshevRolling, IsCarterInPlaneStrain) {
  const HertzBound bound(2, 3);
  const PlaneKernel kernel(material, 200);
  const ChebyshevRolling rolling(kernel, bound);
  for (const double stick_ratio : {0.02, 0.3, 0.6, 0.99}) {
    const Carter carter = Carter::from_stick_ratio(material, bound, stick_ratio);
    const ChebyshevSolution by_creepage = rolling.solve(PrescribedCreepage{carter.creepage()});
    const ChebyshevSolution by_force = rolling.solve(PrescribedForce{carter.force()});
    EXPECT_NEAR(by_creepage.force() / carter.force(), 1, 1e-13);
    EXPECT_NEAR(by_force.creepage() / carter.creepage(), 1, 1e-13);
    EXPECT_NEAR(by_force.stick_edge(), 2 - 4 * stick_ratio, 1e-13);
    for (const double x : {-1.99, -1.0, 0.3, 1.9, 2.0}) {
      EXPECT_NEAR(by_force.traction(x), carter.traction(x), 1e-13) << x;
      EXPECT_NEAR(by_force.slip(x), carter.slip(x), 1e-7) << x;  // a square root of rounding at b
    }
    EXPECT_NEAR(by_creepage.displacement(2), edge_displacement(kernel, carter), 1e-12);
    EXPECT_EQ(rolling.solve(PrescribedForce{-carter.force()}).creepage(), -by_force.creepage());
  }
}

// The force is a difference to that of full sliding, so that it loses digits as the load vanishes,
// but no more.
TEST(ChebyshevRolling, IsCarterNextToAdhesionEverywhere) {
  const HertzBound bound(2, 3);
  const ChebyshevRolling rolling(PlaneKernel(material, 200), bound);
  for (const double size : {1e-4, 1e-5, 1e-6, 1e-7}) {
    const Carter carter = Carter::from_creepage(material, bound, size * bound.peak());
    const double rounding = 2e-15 / size;
    EXPECT_NEAR(rolling.solve(PrescribedCreepage{carter.creepage()}).force() / carter.force(), 1,
                rounding);
    EXPECT_NEAR(rolling.solve(PrescribedForce{carter.force()}).creepage() / carter.creepage(), 1,
                rounding);
  }
}

// The closed form of bounds with a polynomial, evaluated independently of this project to 12 and 15
// digits.
TEST(ChebyshevRolling, MeetsTheClosedFormOfAPolynomialBound) {
  const ChebyshevRolling rolling(PlaneKernel(material, 1), some_bound());
  const ChebyshevSolution solution = rolling.solve(PrescribedCreepage{0.4});
  EXPECT_NEAR(solution.stick_edge(), -0.138128361539, 1e-12);
  EXPECT_NEAR(solution.force(), -0.978614568537603, 1e-14);
}

struct Strip {
  double width;
  Eigen::Index most_unknowns;
};

// For strips the truth is the same with all 64 unknowns; and the contact conditions, which the
// solver does not use but at collocation points.
TEST(ChebyshevRolling, ConvergesForStrips) {
  for (const auto& [width, most] : {Strip{1, 40}, {2, 32}, {5, 16}, {1e4, 8}}) {
    const StripKernel kernel(material, width);
    const ChebyshevRolling rolling(kernel, some_bound());
    const ChebyshevRolling more(kernel, some_bound(), 64);
    EXPECT_LE(rolling.unknowns(), most);
    for (const Load& load : {Load(PrescribedCreepage{0.05}), Load(PrescribedCreepage{0.4}),
                             Load(PrescribedCreepage{-1.1}), Load(PrescribedForce{-1.3})}) {
      const ChebyshevSolution solution = rolling.solve(load);
      const ChebyshevSolution expected = more.solve(load);
      EXPECT_NEAR(solution.force() / expected.force(), 1, 1e-11);
      EXPECT_NEAR(solution.creepage() / expected.creepage(), 1, 1e-11);
      for (const double x : {-0.9, -0.1, 0.6, 0.99}) {
        EXPECT_NEAR(solution.traction(x), expected.traction(x), 1e-11) << x;
        EXPECT_NEAR(solution.slip(x), expected.slip(x), 1e-11) << x;
      }
      EXPECT_LT(solution.evidence().bound_violation(), 1e-12);
      EXPECT_LT(solution.evidence().slip_violation(), 1e-12);
      if (solution.stick_edge() == 1) continue;
      // In adhesion w = du/dx everywhere.
      constexpr double h = 1e-4;
      const double x = (1 + solution.stick_edge()) / 2 + 0.01;
      const double slope = (solution.displacement(x + h) - solution.displacement(x - h)) / (2 * h);
      EXPECT_NEAR(slope, solution.creepage(), 1e-9);
    }
  }
}

TEST(ChebyshevRolling, IsScaleInvariant) {
  const ChebyshevRolling unit(StripKernel(material, 3), some_bound());
  const ChebyshevRolling steel(StripKernel({1.44e5, 0.28}, 18), some_bound(6, 300));
  const ChebyshevSolution s = unit.solve(PrescribedForce{-0.8});
  const ChebyshevSolution t = steel.solve(PrescribedForce{-0.8 * 6 * 300});
  EXPECT_NEAR(t.creepage() * 1e5 / 300 / s.creepage(), 1, 1e-13);
  EXPECT_NEAR(t.traction(1.2) / 300, s.traction(0.2), 1e-13);
  EXPECT_NEAR(t.displacement(1.2) * 1e5 / 1800, s.displacement(0.2), 1e-12);
}

TEST(ChebyshevRolling, KnowsFullSlidingAndRest) {
  const ChebyshevRolling rolling(StripKernel(material, 3), some_bound());
  const ChebyshevSolution sliding = rolling.solve(PrescribedCreepage{-2});
  EXPECT_EQ(sliding.force(), some_bound().total());
  EXPECT_EQ(sliding.traction(0.3), some_bound()(0.3));
  EXPECT_LT(sliding.slip(0.9), 0);
  EXPECT_FALSE(sliding.sticks(1));
  EXPECT_EQ(rolling.solve(PrescribedForce{-1e-12}).force(), -1e-12);
  EXPECT_EQ(rolling.solve(PrescribedCreepage{1e-14}).creepage(), 1e-14);
  const ChebyshevSolution rest = rolling.solve(PrescribedCreepage{0});
  EXPECT_EQ(rest.force(), 0);
  EXPECT_EQ(rest.traction(0.3), 0);
  const ChebyshevSolution little = rolling.solve(PrescribedCreepage{1e-10});
  const ChebyshevSolution twice = rolling.solve(PrescribedCreepage{2e-10});
  EXPECT_NEAR(twice.force() / little.force(), 2, 1e-7);
  EXPECT_NEAR(twice.traction(0.3) / little.traction(0.3), 2, 1e-6);
  EXPECT_THROW(rolling.solve(PrescribedForce{some_bound().total()}), std::invalid_argument);
}

// A bound with a dent slips there, too, between two stick zones.
TEST(ChebyshevRolling, NoticesSeveralStickZones) {
  const PolynomialBound dented(1, 1, (Eigen::VectorXd(3) << 0.05, 0, 1).finished());
  const ChebyshevRolling rolling(PlaneKernel(material, 1), dented);
  EXPECT_THROW(rolling.solve(PrescribedForce{-0.5 * dented.total()}), NotConverged);
}

// The second zone begins with a violation of zero: the least load that is refused has one that only
// just is no rounding.
TEST(ChebyshevRolling, NoticesASecondStickZoneFromItsBeginning) {
  const PolynomialBound dented(1, 1, (Eigen::VectorXd(3) << 0.05, 0, 1).finished());
  const ChebyshevRolling rolling(PlaneKernel(material, 1), dented);
  double accepted = 0, refused = 0.5, violation = 1;
  for (int k = 0; k < 40; ++k) {
    const double part = (accepted + refused) / 2;
    try {
      rolling.solve(PrescribedForce{-part * dented.total()});
      accepted = part;
    } catch (const NotConverged& error) {
      refused = part;
      violation = error.residual();
    }
  }
  EXPECT_GT(accepted, 0.1);
  EXPECT_LT(violation, 2e-9);
}

TEST(ChebyshevRolling, RefusesWhatItIsNotFor) {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(5, -1, 1);
  EXPECT_THROW(
      ChebyshevRolling(PlaneKernel(material, 1), TabulatedBound(1, x, Eigen::VectorXd::Ones(5))),
      std::invalid_argument);
  EXPECT_THROW(ChebyshevRolling(StripKernel(material, 0.2), some_bound()), NotConverged);
}

}  // namespace microslip::chebyshev_rolling_test
