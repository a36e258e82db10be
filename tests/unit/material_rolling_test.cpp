// SPDX-License-Identifier: GPL-3.0-or-later
// Transient rolling on a grid that is fixed to the material.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/work.hpp"

namespace microslip {
namespace {

constexpr Material material{1, 0.28};
const double full_sliding = HertzBound(1, 1).total();

TransientProblem problem(Eigen::Index n = 41) {
  return {.kernel = PlaneKernel(material, 200),
          .bound = HertzBound(1, 1),
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .scheme = MaterialFixed{}};
}

void roll_quietly(TransientRolling& rolling, double distance, const std::vector<double>& lengths,
                  const Load& load) {
  rolling.roll(distance, lengths, load, [](const TransientState&) {});
}

double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

TransientRolling rolled_from_shift(double step_ratio, double elements, Eigen::Index n = 100) {
  TransientRolling rolling(problem(n), CattaneoShift{-0.64 * full_sliding});
  const double dx = 2 / static_cast<double>(n);
  roll_quietly(rolling, elements * dx, {step_ratio * dx}, PrescribedForce{-0.64 * full_sliding});
  return rolling;
}

double total_variation(const Eigen::VectorXd& values) {
  return (values.tail(values.size() - 1) - values.head(values.size() - 1)).lpNorm<1>();
}

int local_extrema(const Eigen::VectorXd& values) {
  int count = 0;
  for (Eigen::Index i = 1; i + 1 < values.size(); ++i) {
    count += (values[i] - values[i - 1]) * (values[i + 1] - values[i]) < 0 ? 1 : 0;
  }
  return count;
}

// The direct scheme: 3e-2 at c = 0.1. Where a step ends within an element, what is taken as linear
// is how the nodes before the edge have slipped.
TEST(MaterialFixed, TractionsDoNotDependOnTheStep) {
  for (const double elements : {25.0, 50.0, 50.3}) {
    const TransientRolling whole = rolled_from_shift(1, elements);
    for (const double c : {0.9, 0.75, 0.5, 0.31, 0.1, 0.01, 2.0, 2.5}) {
      const TransientRolling part = rolled_from_shift(c, elements);
      EXPECT_LT(largest_difference(part.x(), whole.x()), 1e-12);
      const Eigen::VectorXd difference = part.state().traction - whole.state().traction;
      EXPECT_LT(difference.lpNorm<1>() * 0.02, elements == 50.3 ? 5e-6 : 1e-12) << c;
      EXPECT_LT(total_variation(part.state().traction),
                total_variation(whole.state().traction) + 1e-4);
      EXPECT_EQ(local_extrema(part.state().traction), local_extrema(whole.state().traction));
    }
  }
}

// How the nodes before the edge have slipped is known where a step ended: a way that ends there in
// each element, as it does for all of these, is that of the shortest steps.
TEST(MaterialFixed, TractionsWithinAnElementAreThoseOfShortSteps) {
  for (const double elements : {50.5, 50.25}) {
    const TransientRolling fine = rolled_from_shift(0.005, elements);
    for (const double c : {0.25, 0.125, 0.05, 0.01}) {
      const TransientRolling coarse = rolled_from_shift(c, elements);
      EXPECT_LT(largest_difference(coarse.state().traction, fine.state().traction), 1e-12) << c;
    }
  }
}

// What a step finds has not changed where none of the steps is a part of another.
TEST(MaterialFixed, RandomStepsLeadToTheSameTractions) {
  const TransientRolling whole = rolled_from_shift(1, 60, 40);
  TransientRolling rolling(problem(40), CattaneoShift{-0.64 * full_sliding});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-7, 0.5);
  std::vector<double> lengths(30);
  for (double& length : lengths) length = 0.05 * std::pow(10, exponent(random));
  roll_quietly(rolling, 3, lengths, PrescribedForce{-0.64 * full_sliding});
  EXPECT_LT(largest_difference(rolling.state().traction, whole.state().traction), 1e-9);
}

// Nodes enter and leave while their tractions change evenly; so does the creepage.
TEST(MaterialFixed, TheCreepageIsSmoothForSmallSteps) {
  const auto largest_jump = [](Eigen::Index n, double step_ratio) {
    const double dx = 2 / static_cast<double>(n);
    TransientRolling rolling = rolled_from_shift(1, 0.75 * static_cast<double>(n), n);
    double jump = 0, before = 0;
    for (int k = 0; k < 4 / step_ratio; ++k) {
      rolling.step(step_ratio * dx, PrescribedForce{-0.64 * full_sliding});
      const double creepage = rolling.state().creepage;
      if (before != 0) jump = std::max(jump, std::abs(creepage / before - 1));
      before = creepage;
    }
    return jump;
  };
  EXPECT_LT(largest_jump(200, 0.1), 0.025);
  EXPECT_LT(largest_jump(200, 0.01), 0.03);
  EXPECT_LT(largest_jump(400, 0.1), 0.0125);
}

// Slip displacement of a material point: the shift of the bodies, and what its displacement by
// elements has changed, those that have left included.
TEST(MaterialFixed, SlipIsThatOfMaterialPoints) {
  const TransientProblem p = problem(20);
  TransientRolling rolling(p, CattaneoShift{-0.5 * full_sliding});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> ratio(0, 3);
  const double dx = 0.1;
  const auto displacement = [&](const Eigen::VectorXd& at, const Eigen::VectorXd& x,
                                const Eigen::VectorXd& traction) {
    return Eigen::VectorXd(at.unaryExpr([&](double xi) {
      double sum = 0;
      for (Eigen::Index j = 0; j < x.size(); ++j) {
        sum +=
            traction[j] * influence(p.kernel, constant_shape(), dx, std::round((xi - x[j]) / dx));
      }
      return sum;
    }));
  };
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    const double length = ratio(random) * dx;
    const Eigen::VectorXd x = rolling.x();
    const Eigen::VectorXd traction = rolling.state().traction;
    rolling.step(length, PrescribedForce{-0.7 * full_sliding});
    const TransientState& state = rolling.state();
    EXPECT_NEAR(state.force, -0.7 * full_sliding, 1e-12);
    const Eigen::VectorXd then =
        rolling.x() + Eigen::VectorXd::Constant(rolling.x().size(), length);
    const Eigen::VectorXd slip =
        displacement(rolling.x(), rolling.x(), state.traction) - displacement(then, x, traction);
    for (Eigen::Index i = 0; i < slip.size(); ++i) {
      EXPECT_LE(std::abs(state.traction[i]), rolling.bound()[i] + 1e-12);
      if (rolling.bound()[i] == 0 || then[i] > 1 - 0.8 * dx) continue;
      EXPECT_NEAR(length * state.slip[i], length * state.creepage + slip[i], 1e-11);
      ++compared;
    }
  }
  EXPECT_GT(compared, 60 * 15);
}

// Of either sign and with reversals, force or creepage, strips and tables: the conditions of
// contact, and energy that is not made.
TEST(MaterialFixed, AnySequenceOfStepsMeetsTheContactConditions) {
  Eigen::VectorXd at(4), values(4);
  at << -1, -0.2, 0.5, 0.9;
  values << 0, 1, 0.7, 0.5;
  const std::vector<TractionBound> bounds = {HertzBound(1, 1), TabulatedBound(1, at, values)};
  for (const Kernel& kernel :
       {Kernel(PlaneKernel(material, 200)), Kernel(StripKernel(material, 2))}) {
    for (const TractionBound& bound : bounds) {
      TransientProblem p = problem(30);
      p.kernel = kernel;
      p.bound = bound;
      const double most = full_sliding_force(bound);
      TransientRolling rolling(p, Eigen::VectorXd(0.3 * bound_at(p.bound, p.grid.nodes())));
      std::mt19937 random(7);
      std::uniform_real_distribution<double> unit(-1, 1);
      for (int k = 0; k < 200; ++k) {
        const double length = std::pow(10.0, 1.5 * unit(random) - 1.1) * p.grid.spacing();
        const Load load = k % 2 == 0 ? Load(PrescribedForce{0.99 * unit(random) * most})
                                     : Load(PrescribedCreepage{unit(random)});
        const double energy = rolling.elastic_energy();
        rolling.step(length, load);
        const TransientState& state = rolling.state();
        EXPECT_NEAR(rolling.bound().sum() * p.grid.spacing(), most, 1e-12);
        if (const auto* force = std::get_if<PrescribedForce>(&load)) {
          EXPECT_NEAR(state.force, force->value, 1e-11);
        } else {
          const double balance = state.mean_force * state.creepage + state.dissipation;
          EXPECT_NEAR(length * balance, energy - rolling.elastic_energy(), 1e-11);
        }
        for (Eigen::Index i = 0; i < rolling.x().size(); ++i) {
          const double g = rolling.bound()[i];
          const Zone zone = state.zones[static_cast<std::size_t>(i)];
          EXPECT_LE(std::abs(state.traction[i]), g + 1e-11);
          if (zone != Zone::adhesion) {
            EXPECT_NEAR(state.traction[i], static_cast<double>(zone) * g, 1e-14);
          }
        }
      }
    }
  }
}

// Means of the bound are differences of its integral: 1e-12 dx would leave one digit.
TEST(MaterialFixed, TinyStepsKeepTheirDigits) {
  double first = 0;
  for (const double step_ratio : {1e-3, 1e-6, 1e-9}) {
    TransientRolling rolling(problem(), CattaneoShift{-0.64 * full_sliding});
    rolling.step(step_ratio * 2 / 41, PrescribedForce{-0.64 * full_sliding});
    if (first == 0) first = rolling.state().creepage;
    EXPECT_NEAR(rolling.state().creepage / first, 1, 0.02) << step_ratio;
  }
}

// A partition stays where it is in the contact, so that a search begins with the last one moved by
// a node in every element: three rounds a step instead of four at c = 0.7, two instead of three at
// 0.45.
TEST(MaterialFixed, APartitionIsLookedForWhereItWas) {
  const std::vector<std::pair<double, int>> most = {{0.7, 310}, {0.45, 230}, {1, 100}};
  for (const auto& [c, rounds] : most) {
    TransientRolling rolling = rolled_from_shift(c, 200);
    int count = 0;
    for (int k = 0; k < 100; ++k) {
      rolling.step(c * 0.02, PrescribedForce{-0.64 * full_sliding});
      count += rolling.state().iterations;
    }
    EXPECT_LE(count, rounds) << c;
  }
}

TEST(MaterialFixed, TheWindowStaysAsLargeAsTheContact) {
  TransientRolling rolling(problem(20), CattaneoShift{-0.64 * full_sliding});
  for (const double length : {0.037, 1.0, 0.31}) {
    roll_quietly(rolling, 3, {length}, PrescribedForce{-0.64 * full_sliding});
    EXPECT_EQ(rolling.x().size(), 23);
    EXPECT_GE(rolling.state().adhesion_elements + rolling.state().slip_elements, 20);
    EXPECT_LE(rolling.state().adhesion_elements + rolling.state().slip_elements, 21);
  }
}

// After four contact widths Carter's solution is there, up to the last node, at any phase.
TEST(MaterialRolling, ValuesAtTheNodesAreThoseOfTheTraction) {
  const HertzBound bound(1, 1);
  const Carter exact = Carter::from_stick_ratio(material, bound, 0.6);
  const double dx = 0.02;
  for (const double part : {0.0, 0.2, 0.5, 0.9}) {
    TransientRolling rolling({.kernel = PlaneKernel(material, 200),
                              .bound = bound,
                              .grid = Grid({.half_width = 1, .elements = 100}),
                              .basis = constant_basis(),
                              .scheme = MaterialFixed{}},
                             CattaneoShift{exact.force()});
    rolling.roll((400 + part) * dx, {dx}, PrescribedForce{exact.force()},
                 [](const TransientState&) {});
    const Eigen::VectorXd values = rolling.traction_at_nodes();
    EXPECT_LE((values.cwiseAbs() - rolling.bound_at_nodes()).maxCoeff(), 1e-12);
    const ChebyshevSolution fields =
        ChebyshevRolling(PlaneKernel(material, 200), bound).solve(PrescribedForce{exact.force()});
    const Eigen::VectorXd displacement = rolling.displacement();
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double x = rolling.x()[i];
      if (std::abs(x) >= 1) continue;
      EXPECT_NEAR(displacement[i], fields.displacement(x), 3e-4) << x;
      if (x < 0.9) continue;
      EXPECT_NEAR(values[i], exact.traction(x), 0.02 * std::abs(exact.traction(x))) << x;
    }
  }
}

}  // namespace
}  // namespace microslip
