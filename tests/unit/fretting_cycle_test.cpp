// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/fretting_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/support/quadrature.hpp"

namespace microslip::fretting_cycle_test {

const Material material{1.44, 0.28};              // 2 (1 - nu)/G = 1
const HertzBound bound(1, 2 / std::numbers::pi);  // full sliding at 1
constexpr double k = 1 / std::numbers::pi;

// In 30 digits: 2 (1 - t) ln(1 - t) + 2 t - t^2, and with L0 = 10 a the shift under F*,
// t (ln 20 + 1/2) + (1 - t) ln(1 - t)/2.
TEST(FrettingCycle, KnownValues) {
  const double known[][3] = {{0.25, 0.00597689132232861, 0.766052291219080},
                             {0.5, 0.0568528194400547, 1.57457934163701},
                             {0.9, 0.529482981401191, 3.03102979154889}};
  for (const auto& [tau, lost, shift] : known) {
    const FrettingCycle cycle(material, bound, -tau);
    EXPECT_NEAR(cycle.dissipation() / k, lost, 3e-15);
    EXPECT_NEAR(cycle.shift(-tau, 10) / k, shift, 3e-15);
    EXPECT_NEAR(cycle.shift(tau, 10) / k, -shift, 3e-15);
  }
}

// The area of the loop of force and shift, whatever L0 is.
TEST(FrettingCycle, DissipationIsTheAreaOfTheLoop) {
  for (const double tau : {0.1, 0.5, 0.9, 1.0}) {
    const FrettingCycle cycle(material, bound, tau);
    for (const double length : {2.0, 200.0}) {
      // The way forth is the mirror image of the way back.
      const auto width = [&](double force) {
        return -cycle.shift(force, length) - cycle.shift(-force, length);
      };
      const double area = integrate(width, -tau, tau, 1e-12);
      EXPECT_NEAR(std::abs(area), cycle.dissipation(), 1e-10) << tau;
    }
  }
}

// Friction at the bound dissipates on the way back, where the slip follows from the surface
// displacements.
TEST(FrettingCycle, DissipationIsThatOfFriction) {
  const double tau = 0.6, stick = std::sqrt(1 - tau);
  const FrettingCycle cycle(material, bound, tau);
  const auto displacement = [&](double x, double force) {
    const auto density = [&](double y) {
      return -k * std::log(std::abs(x - y)) * cycle.traction(y, force);
    };
    double sum = 0;
    for (const auto& [from, to] : {std::pair(-1.0, -stick), std::pair(-stick, stick),
                                   std::pair(stick, x), std::pair(x, 1.0)}) {
      sum += integrate(density, from, to, 1e-9);
    }
    return sum;
  };
  const auto power = [&](double x) {
    const double change = displacement(x, -tau) - displacement(x, tau);
    const double rigid = cycle.shift(-tau, 1) - cycle.shift(tau, 1);
    return bound(x) * (rigid + change);
  };
  // Two slip zones, and two ways.
  EXPECT_NEAR(4 * integrate(power, stick, 1, 1e-7), cycle.dissipation(), 1e-6);
}

TEST(FrettingCycle, SmallForcesLoseTheirCube) {
  for (const double tau : {1e-12, 1e-6, 1e-3}) {
    const double cubes = tau * tau * tau * (1 + tau / 2 + 0.3 * tau * tau) / 3;
    EXPECT_NEAR(FrettingCycle(material, bound, tau).dissipation() / (k * cubes), 1, 1e-9) << tau;
  }
  // Both ways of computing it, where one takes over.
  const double below = FrettingCycle(material, bound, std::nextafter(0.5, 0)).dissipation();
  EXPECT_NEAR(FrettingCycle(material, bound, 0.5).dissipation() / below, 1, 1e-14);
}

TEST(FrettingCycle, TurnsCattaneosTractionsRound) {
  const FrettingCycle cycle(material, bound, 0.7);
  const Cattaneo forth(material, bound, 0.7);
  for (const double x : {-0.95, 0.0, 0.5, 0.6, 0.99}) {
    EXPECT_NEAR(cycle.traction(x, 0.7), forth.traction(x), 1e-15);
    EXPECT_NEAR(cycle.traction(x, -0.7), -forth.traction(x), 1e-15);
    EXPECT_LE(std::abs(cycle.traction(x, 0.1)), bound(x) * (1 + 1e-15));
  }
  EXPECT_LT(cycle.traction(0.99, 0.1), 0);
  EXPECT_GT(cycle.traction(0.7, 0.1), 0);
  EXPECT_THROW(cycle.traction(0, 0.71), std::invalid_argument);
  EXPECT_THROW(FrettingCycle(material, bound, 1.01), std::invalid_argument);
}

}  // namespace microslip::fretting_cycle_test
