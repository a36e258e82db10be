// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/transient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <tuple>

#include "microslip/halfspace/influence.hpp"
#include "microslip/reference/cattaneo.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::transient_test {

constexpr Material material{1, 0.28};
const double full_sliding = HertzBound(1, 1).total();

TransientProblem problem(AdvectionScheme scheme, Eigen::Index n = 41, double peak = 1) {
  return {.contact = {PlaneKernel(material, 200), HertzBound(1, peak)},
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .scheme = scheme};
}

void roll_quietly(TransientRolling& rolling, double distance, std::vector<double> lengths,
                  const Load& load) {
  rolling.roll(distance, lengths, load, [](const TransientState&) {});
}

double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

class EveryScheme : public testing::TestWithParam<AdvectionScheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme,
                         testing::Values(Direct{}, Relaxed{1}, RelaxedTraction{1}, Fractional{}),
                         [](const auto& of) { return name_of(of.param); });

// Slip from displacements: dq s = dq w + u(x) - u'(x + dq), the last by an interpolation that is
// exact for c = 1.
TEST_P(EveryScheme, AUnitStepIsThatOfTheThesis) {
  TransientRolling rolling(problem(GetParam()));
  rolling.start_from_shift({-0.5 * full_sliding});
  const double dx = rolling.x()[1] - rolling.x()[0];
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd before = rolling.displacement();
    rolling.step(dx, PrescribedForce{-0.6 * full_sliding});
    const TransientState& state = rolling.state();
    const Eigen::VectorXd after = rolling.displacement();
    EXPECT_NEAR(state.force, -0.6 * full_sliding, 1e-12);
    for (Eigen::Index i = 0; i + 1 < rolling.x().size(); ++i) {
      EXPECT_NEAR(state.slip[i], state.creepage + (after[i] - before[i + 1]) / dx, 1e-11);
      EXPECT_LE(std::abs(state.traction[i]), rolling.bound()[i] + 1e-12);
      if (state.zones[static_cast<std::size_t>(i)] == Zone::adhesion) {
        EXPECT_EQ(state.slip[i], 0);
      } else {
        EXPECT_LE(state.slip[i] * state.traction[i], 1e-12);
      }
    }
  }
}

/// Steps of at most an element, under creepages that turn.
void roll_to_and_fro(TransientRolling& rolling, int steps) {
  const double dx = rolling.x()[1] - rolling.x()[0];
  for (int k = 0; k < steps; ++k) {
    rolling.step(dx * (k % 3 == 0 ? 0.4 : 0.9), PrescribedCreepage{3 * std::sin(0.7 * k)});
  }
}

// With few elements, where matrices are dense, and by FFT.
TEST(Transient, ACopyGoesOnAlikeAndByItself) {
  for (const AdvectionScheme scheme :
       {AdvectionScheme(Direct{}), AdvectionScheme(Relaxed{1}), AdvectionScheme(RelaxedTraction{1}),
        AdvectionScheme(Fractional{}), AdvectionScheme(Remembered{})}) {
    for (const Eigen::Index n : {49, 121}) {
      TransientRolling rolling(problem(scheme, n));
      roll_to_and_fro(rolling, 10);
      TransientRolling copy = rolling;
      const Eigen::VectorXd before = rolling.state().traction;
      roll_to_and_fro(copy, 10);
      EXPECT_EQ(rolling.state().traction, before);
      EXPECT_NE(copy.state().traction, before);
      roll_to_and_fro(rolling, 10);
      EXPECT_EQ(copy.state().traction, rolling.state().traction);
      EXPECT_EQ(copy.state().slip, rolling.state().slip);
      EXPECT_EQ(copy.displacement(), rolling.displacement());
      rolling = copy;
      roll_to_and_fro(copy, 10);
      roll_to_and_fro(rolling, 10);
      EXPECT_EQ(copy.state().traction, rolling.state().traction);
    }
  }
}

// Where nothing changes any more, steady rolling with the same difference has been reached.
TEST(Transient, TurnsToTheSteadySolutionOfItsDifference) {
  for (const auto& [scheme, step_ratio, steady_step_ratio] :
       {std::tuple<AdvectionScheme, double, double>{Direct{}, 1, 1},
        {Direct{}, 0.7, 0.7},
        {Direct{}, 1.5, 1.5},
        {Relaxed{1}, 0.3, 1},
        {Relaxed{0.8}, 0.5, 0.8},
        {RelaxedTraction{1}, 0.3, 1}}) {
    const TransientProblem p = problem(scheme);
    for (const Load load : {Load(PrescribedForce{-0.64 * full_sliding})}) {
      TransientRolling rolling(p);
      for (int k = 0; k < 600; ++k) rolling.step(step_ratio * p.grid.spacing(), load);
      const SteadySolution steady =
          solve_steady({.contact = p.contact,
                        .grid = p.grid,
                        .basis = p.basis,
                        .method = Differences{.step_ratio = steady_step_ratio},
                        .load = load});
      EXPECT_LT(largest_difference(rolling.state().traction, steady.traction), 1e-8);
      EXPECT_NEAR(rolling.state().creepage, steady.creepage, 1e-8);
      EXPECT_NEAR(rolling.state().dissipation / steady.dissipation, 1, 0.01);
    }
  }
}

TEST_P(EveryScheme, TheMeanForceOfAStepIsHalfwayBetweenItsEnds) {
  TransientRolling rolling(problem(GetParam()));
  for (const double creepage : {0.3, 0.3, -0.2}) {
    const double before = rolling.state().force;
    rolling.step(0.02, PrescribedCreepage{creepage});
    const double after = rolling.state().force;
    EXPECT_GT(std::abs(after - before), 1e-3);
    EXPECT_DOUBLE_EQ(rolling.state().mean_force, (before + after) / 2);
  }
}

// The creepage that a force needs gives that force.
TEST_P(EveryScheme, ForceAndCreepageDescribeTheSameRolling) {
  TransientRolling by_force(problem(GetParam()));
  TransientRolling by_creepage(problem(GetParam()));
  by_force.start_from_shift({-0.64 * full_sliding});
  by_creepage.start_from_shift({-0.64 * full_sliding});
  for (int k = 0; k < 60; ++k) {
    by_force.step(0.02, PrescribedForce{-0.64 * full_sliding});
    by_creepage.step(0.02, PrescribedCreepage{by_force.state().creepage});
    EXPECT_LT(largest_difference(by_force.state().traction, by_creepage.state().traction), 1e-10);
  }
}

// Loads of both kinds and signs, steps of any length: each step meets the contact conditions, with
// slip recomputed from displacements.
TEST(Transient, AnySequenceOfStepsMeetsTheContactConditions) {
  const TransientProblem p = problem(Direct{}, 30);
  const double dx = p.grid.spacing();
  const Eigen::MatrixXd a = influence_matrix(p.contact.kernel, p.basis, dx, 30);
  TransientRolling rolling(p, Eigen::VectorXd(0.3 * bound_at(p.contact.bound, p.grid.nodes())));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 300; ++k) {
    const double c = std::pow(10.0, 1.5 * unit(random) - 1.1);
    const Load load = k % 2 == 0 ? Load(PrescribedForce{0.99 * unit(random) * full_sliding})
                                 : Load(PrescribedCreepage{unit(random)});
    const Eigen::VectorXd before = rolling.state().traction;
    rolling.step(c * dx, load);
    const TransientState& state = rolling.state();
    const Eigen::VectorXd slip =
        (a * (state.traction - before) +
         influence_difference_matrix(p.contact.kernel, p.basis, dx, 30, c) * before) /
            (c * dx) +
        Eigen::VectorXd::Constant(30, state.creepage);
    for (Eigen::Index i = 0; i < 30; ++i) {
      const double g = rolling.bound()[i];
      EXPECT_LE(std::abs(state.traction[i]), g + 1e-11);
      EXPECT_NEAR(slip[i], state.slip[i], 1e-10 / c);
      if (state.zones[static_cast<std::size_t>(i)] == Zone::adhesion) {
        EXPECT_EQ(state.slip[i], 0);
      } else {
        EXPECT_NEAR(std::abs(state.traction[i]), g, 1e-14);
        EXPECT_LE(state.slip[i] * state.traction[i], 1e-10);
      }
    }
  }
}

TEST(Transient, ALastStepIsShortened) {
  TransientRolling rolling(problem(Direct{}));
  std::vector<double> distances;
  rolling.roll(0.25, {0.1}, PrescribedCreepage{0.1},
               [&](const TransientState& state) { distances.push_back(state.distance); });
  ASSERT_EQ(distances.size(), 3U);
  EXPECT_DOUBLE_EQ(distances[0], 0.1);
  EXPECT_DOUBLE_EQ(distances[2], 0.25);
}

TEST(Transient, CountsSteps) {
  EXPECT_EQ(number_of_steps(1, {0.1}), 10U);
  EXPECT_EQ(number_of_steps(25 * 0.04, {0.05 * 0.04}), 500U);
  EXPECT_EQ(number_of_steps(50, {0.8}), 63U);
  EXPECT_EQ(number_of_steps(1, {0.3, 0.1}), 5U);
  EXPECT_EQ(number_of_steps(0.05, {0.1}), 1U);
  EXPECT_EQ(number_of_steps(1.00001, {0.1}), 11U);  // a short one is a step
  EXPECT_EQ(number_of_steps(24, {1e-6}), 24000000U);
  EXPECT_THROW(number_of_steps(1, {0}), std::invalid_argument);
  EXPECT_THROW(number_of_steps(0, {1}), std::invalid_argument);
}

// In adhesion everywhere and without creepage, steps of any lengths add up to whole elements.
TEST(Transient, FractionalStepsAddUp) {
  const Eigen::VectorXd start = Eigen::VectorXd::Random(41);
  const auto rolled = [&](std::vector<double> ratios) {
    TransientRolling rolling(problem(Fractional{}, 41, 1e6));
    rolling.start_from(start);
    const double dx = rolling.x()[1] - rolling.x()[0];
    for (double& ratio : ratios) ratio *= dx;
    roll_quietly(rolling, 6 * dx, ratios, PrescribedCreepage{0});
    return rolling.state().traction;
  };
  EXPECT_LT(largest_difference(rolled({0.5, 1.3, 0.2}), rolled({1})), 1e-10);
}

// Thesis (7.4)-(7.10): the two relaxations are the same in adhesion.
TEST(Transient, RelaxationsAgreeInAdhesion) {
  TransientRolling by_matrix(problem(Relaxed{1}, 41, 1e6));
  TransientRolling by_traction(problem(RelaxedTraction{1}, 41, 1e6));
  const Eigen::VectorXd start = Eigen::VectorXd::Random(41);
  by_matrix.start_from(start);
  by_traction.start_from(start);
  for (int k = 0; k < 30; ++k) {
    by_matrix.step(0.02, PrescribedCreepage{0.3});
    by_traction.step(0.02, PrescribedCreepage{0.3});
  }
  EXPECT_LT(largest_difference(by_matrix.state().traction, by_traction.state().traction), 1e-12);
}

// Nothing in a step divides by c. The force stays what it is, to the last digit: the shortest step
// would make up for an error of the start, 1e-16 of it, by a tenth of its creepage.
TEST(Transient, TinyStepsKeepTheirDigits) {
  for (const AdvectionScheme scheme : {AdvectionScheme(Direct{}), AdvectionScheme(Relaxed{1})}) {
    TransientRolling rolling(problem(scheme));
    rolling.start_from_shift({-0.64 * full_sliding});
    const double dx = rolling.x()[1] - rolling.x()[0];
    double first = 0;
    for (const double step_ratio : {1e-3, 1e-6, 1e-9, 1e-12}) {
      rolling.start_from_shift({-0.64 * full_sliding});
      rolling.step(step_ratio * dx, PrescribedForce{rolling.state().force});
      if (first == 0) first = rolling.state().creepage;
      EXPECT_NEAR(rolling.state().creepage / first, 1, 0.02) << step_ratio;
    }
  }
}

TEST(Transient, AnUnchangedPartitionIsTriedOnce) {
  TransientRolling rolling(problem(Direct{}));
  const double dx = rolling.x()[1] - rolling.x()[0];
  roll_quietly(rolling, 4, {dx}, PrescribedForce{-0.64 * full_sliding});
  EXPECT_EQ(rolling.state().iterations, 1);
}

TEST(Transient, StartsFromTractionsWithinTheBound) {
  TransientRolling rolling(problem(Direct{}));
  rolling.start_from(-0.5 * rolling.bound());
  EXPECT_NEAR(rolling.state().force, -0.5 * full_sliding, 0.005);
  EXPECT_EQ(rolling.state().slip_elements, 0);
  rolling.start_from(rolling.bound());
  EXPECT_EQ(rolling.state().adhesion_elements, 0);
  EXPECT_NO_THROW(rolling.start_from(1.0009 * rolling.bound()));  // as printed with four digits
  EXPECT_THROW(rolling.start_from(1.002 * rolling.bound()), std::invalid_argument);
}

TEST(Transient, RejectsStepsOutsideTheRange) {
  TransientRolling relaxed(problem(Relaxed{0.5}));
  EXPECT_THROW(relaxed.step(0.6 * 2 / 41, PrescribedCreepage{0.1}), std::invalid_argument);
  EXPECT_THROW(relaxed.step((0.5 + 1e-9) * 2 / 41, PrescribedCreepage{0.1}), std::invalid_argument);
  EXPECT_NO_THROW(relaxed.step((0.5 + 1e-15) * 2 / 41, PrescribedCreepage{0.1}));  // rounding
  EXPECT_THROW(relaxed.step(-0.01, PrescribedCreepage{0.1}), std::invalid_argument);
  EXPECT_THROW(relaxed.step(0, PrescribedForce{0.1}), std::invalid_argument);
  EXPECT_THROW(TransientRolling(problem(Fractional{}, 40)), std::invalid_argument);
  TransientProblem quadratic = problem(Fractional{});
  quadratic.basis = quadratic_basis();
  EXPECT_THROW(TransientRolling{quadratic}, std::invalid_argument);
}

}  // namespace microslip::transient_test
