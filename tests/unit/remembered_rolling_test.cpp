// SPDX-License-Identifier: GPL-3.0-or-later
// Transient rolling where the material remembers its displacement.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "microslip/rolling/transient.hpp"

namespace microslip::remembered_rolling_test {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Material material{1, 0.28};
const double full_sliding = HertzBound(1, 1).total();

TransientProblem problem(Index n = 41) {
  return {.contact = {PlaneKernel(material, 200), HertzBound(1, 1)},
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .scheme = Remembered{}};
}

double spacing_of(const TransientRolling& rolling) { return rolling.x()[1] - rolling.x()[0]; }

double largest_difference(const VectorXd& a, const VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

// Where whole elements have been travelled, and nothing that sticks has slipped: places in between
// have no part in what is remembered of adhesion. After a shift, the slip zone before the stick
// zone sticks again, by steps as they are.
TEST(Remembered, TractionsDoNotDependOnTheStep) {
  const auto rolled = [](double step_ratio, double elements, const Start& start) {
    TransientRolling rolling(problem(100), start);
    const double dx = spacing_of(rolling);
    rolling.roll(elements * dx, {step_ratio * dx}, PrescribedCreepage{0.3},
                 [](const TransientState&) {});
    return rolling.state();
  };
  for (const double elements : {25.0, 150.0}) {
    for (const double c : {0.5, 0.31, 0.1, 0.01, 2.5}) {
      EXPECT_LT(largest_difference(rolled(c, elements, Rest{}).traction,
                                   rolled(1, elements, Rest{}).traction),
                1e-11)
          << c << ", " << elements;
    }
  }
  const CattaneoShift shift{-0.64 * full_sliding};
  for (const double c : {0.5, 0.1, 0.01}) {
    EXPECT_LT(largest_difference(rolled(c, 25, shift).traction, rolled(1, 25, shift).traction),
              1e-3)
        << c;
  }
}

// Loads of either sign, with reversals, as force or creepage, on strips and under tables meet the
// conditions of contact, and no energy is made.
TEST(Remembered, AnySequenceOfStepsMeetsTheContactConditions) {
  VectorXd at(4), values(4);
  at << -1, -0.2, 0.5, 0.9;
  values << 0, 1, 0.7, 0.5;
  const std::vector<TractionBound> bounds = {HertzBound(1, 1), TabulatedBound(1, at, values)};
  double excess = 0;
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 200)), Kernel(StripKernel(material, 2))}) {
    for (const TractionBound& bound : bounds) {
      TransientProblem p = problem(30);
      p.contact.kernel = kernel;
      p.contact.bound = bound;
      const double most = full_sliding_force(bound);
      TransientRolling rolling(p, VectorXd(0.3 * bound_at(p.contact.bound, p.grid.nodes())));
      std::mt19937 random(7);
      std::uniform_real_distribution<double> unit(-1, 1);
      for (int k = 0; k < 400; ++k) {
        const double length = std::pow(10.0, 1.5 * unit(random) - 1.1) * p.grid.spacing();
        const Load load = k % 2 == 0 ? Load(PrescribedForce{0.99 * unit(random) * most})
                                     : Load(PrescribedCreepage{unit(random)});
        const double energy = rolling.elastic_energy();
        rolling.step(length, load);
        const TransientState& state = rolling.state();
        EXPECT_NEAR(rolling.bound().sum() * spacing_of(rolling), most, 1e-12);
        if (const auto* force = std::get_if<PrescribedForce>(&load)) {
          EXPECT_NEAR(state.force, force->value, 1e-11);
        } else {
          EXPECT_NEAR(state.creepage, std::get<PrescribedCreepage>(load).value, 1e-9);
          const double balance = state.mean_force * state.creepage + state.dissipation;
          EXPECT_NEAR(length * balance, energy - rolling.elastic_energy(), 1e-11);
        }
        EXPECT_LT(state.evidence.bound_violation(), 1e-9);
        for (Index i = 0; i < rolling.x().size(); ++i) {
          excess = std::max(excess, std::abs(state.traction[i]) - rolling.bound()[i]);
        }
      }
    }
  }
  // The mean exceeds the bound at nodes next to the stick-slip point, by a tenth of the distance of
  // the next node to the bound.
  EXPECT_LT(excess, 0.12);
}

// After ten contact widths Carter's solution is there, for any load and number of elements.
TEST(LongRunsOfRemembered, TurnToCarter) {
  for (const double ratio : {1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.64, 0.9}) {
    const double stick = std::sqrt(1 - ratio);
    const double creepage = 2 * (1 - 0.28) * ratio / (1 + stick);
    const double force = -ratio * full_sliding;
    for (const auto& [n, error] : {std::pair<Index, double>{6, 0.02}, {50, 6e-4}, {200, 2e-4}}) {
      for (const double c : {1.0, 0.3}) {
        TransientRolling rolling(problem(n));
        rolling.roll(60, {c * 2 / static_cast<double>(n)}, PrescribedForce{force},
                     [](const TransientState&) {});
        EXPECT_NEAR(rolling.state().creepage / creepage, 1, error) << ratio << ", " << n;
        EXPECT_NEAR(rolling.state().dissipation / (-force * creepage), 1, error);
      }
    }
  }
}

// The place of the stick-slip point, and with it the creepage, goes on evenly while the first
// element begins to slip.
TEST(Remembered, TheFirstElementBeginsToSlipEvenly) {
  for (const Index n : {30, 60, 100}) {
    TransientRolling rolling(problem(n));
    const double dx = spacing_of(rolling);
    constexpr int steps = 400;
    const double most = 0.04 * full_sliding * 60 / static_cast<double>(n);
    std::vector<double> creepages;
    for (int k = 1; k <= steps; ++k) {
      rolling.step(0.1 * dx, PrescribedForce{-most * k / steps});
      creepages.push_back(rolling.state().creepage);
    }
    EXPECT_LT(rolling.state().adhesion_elements, n);
    // An element is travelled in ten steps: what was slack at the start is over after 60.
    for (std::size_t k = 100; k < creepages.size(); ++k) {
      const double bend = creepages[k] - 2 * creepages[k - 1] + creepages[k - 2];
      EXPECT_LT(std::abs(bend), 1e-3 * creepages[k]) << n << ", " << k;
    }
  }
}

TEST(Remembered, StepsOfWholeElementsAreNotDivided) {
  TransientRolling rolling(problem(50));
  EXPECT_NEAR(spacing_of(rolling), 2.0 / 50, 1e-15);
  rolling.roll(10, {2.0 / 50}, PrescribedForce{-0.5 * full_sliding}, [](const TransientState&) {});
  rolling.step(2.0 / 50, PrescribedForce{-0.5 * full_sliding});
  EXPECT_EQ(rolling.state().iterations, 1);
}

// The slip at nodes loses what the balance of energy says, to first order: its zone ends between
// nodes.
TEST(LongRunsOfRemembered, LoseTheEnergyOfSteadyRollingBySlip) {
  for (const double ratio : {0.64, 0.9}) {
    const double force = -ratio * full_sliding;
    for (const auto& [n, error] : {std::pair<Index, double>{50, 0.05}, {200, 0.0125}}) {
      for (const double c : {1.0, 0.3}) {
        TransientRolling rolling(problem(n));
        rolling.roll(60, {c * 2 / static_cast<double>(n)}, PrescribedForce{force},
                     [](const TransientState&) {});
        const TransientState& state = rolling.state();
        EXPECT_NEAR(state.end_dissipation / (-force * state.creepage), 1, error)
            << ratio << ", " << n << ", " << c;
      }
    }
  }
}

/// Integral of f over sqrt of the product of distances from both ends, by the midpoint rule in the
/// angle.
template <class Function>
double weighed(double low, double high, const Function& f) {
  constexpr int points = 2000;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double part = (1 - std::cos((i + 0.5) * std::numbers::pi / points)) / 2;
    sum += f(low + (high - low) * part) * std::numbers::pi / points;
  }
  return sum;
}

/// Strain at any place: linear between the middles of elements.
auto strain_of(const TransientRolling& rolling) {
  return [u = rolling.displacement(), x = rolling.x()](double at) {
    const Index last = x.size() - 3;
    const double place = std::clamp((at - x[0]) / (x[1] - x[0]) - 0.5, 0.0, double(last) + 1);
    const Index k = std::min(static_cast<Index>(place), last);
    const auto between = [&](Index i) { return (u[i + 1] - u[i]) / (x[1] - x[0]); };
    return std::lerp(between(k), between(k + 1), place - static_cast<double>(k));
  };
}

// The inversion on the stick zone [b, 1], docs/theory.md, with 2 (1 - nu)/G = 1: the strain of what
// sticks and the bound of what slips give the force, and meet a condition at the stick-slip point,
// which they do not ahead of it.
TEST(Remembered, StrainAndBoundGiveTheStickSlipPointAndTheForce) {
  TransientProblem of_strain = problem(400);
  of_strain.contact.kernel = PlaneKernel({1.44, 0.28}, 20);
  TransientRolling rolling(of_strain);
  const double dx = spacing_of(rolling);
  for (int i = 0; i < 1200; ++i) {  // not steady: the creepage changes over less than the contact
    rolling.step(dx, PrescribedCreepage{0.35 + 0.15 * std::sin(4 * i * dx)});
    if (i < 800 || i % 50 != 0) continue;
    const auto strain = strain_of(rolling);
    // Over a slip zone from -1 to b, whose ends have no product of roots but b's.
    const auto slipping = [](double t) {
      return std::sqrt(1 - t * t) * std::sqrt((1 + t) / (1 - t));
    };
    const auto missing = [&](double b) {
      return weighed(b, 1, strain) / weighed(-1, b, slipping) - 1;
    };
    const auto& zones = rolling.state().zones;
    const double b = rolling.x()[std::ranges::find(zones, Zone::adhesion) - zones.begin()];
    EXPECT_LT(std::abs(missing(b)), 8e-3) << i;
    EXPECT_GT(std::abs(missing(b + 0.1)), 0.1) << i;
    const double force = -weighed(b, 1, [&](double t) { return strain(t) * (t - b); }) -
                         weighed(-1, b, [&](double t) { return slipping(t) * (b - t); });
    EXPECT_NEAR(force / rolling.state().force, 1, 2e-4) << i;
  }
}

// By that formulation itself, with e on cells of 0.04, 0.02 and 0.01, extrapolated: L0 = 20.
TEST(Remembered, ForceFromRestIsThatOfTheStrainThatEnters) {
  TransientProblem of_strain = problem(400);
  of_strain.contact.kernel = PlaneKernel({1.44, 0.28}, 20);
  TransientRolling rolling(of_strain);
  double last = 0;
  for (const auto& [distance, force] :
       {std::pair{1.0, -0.15748}, {2.0, -0.28384}, {8.0, -0.53526}}) {
    rolling.roll(distance - last, {0.005}, PrescribedCreepage{0.2}, [](const TransientState&) {});
    last = distance;
    EXPECT_NEAR(rolling.state().force, force, 1.5e-5) << distance;
  }
}

}  // namespace microslip::remembered_rolling_test
