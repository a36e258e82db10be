// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of generated runs: loads in them against values at many places, and results against those
// of many short steps.
#include "microslip/rolling/straight_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/interpolation.hpp"

namespace microslip::straight_steps_test {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr std::size_t million = 1000000;

/// Waves of a run in time, and noise from row to row.
VectorXd waves(const VectorXd& t, double mean, double amplitude, double noise,
               std::mt19937& random) {
  std::uniform_real_distribution<double> part(0, 1);
  const double first = 6 * part(random), second = 1 + 3 * part(random);
  return VectorXd::NullaryExpr(t.size(), [&](Index i) {
    const double wave = std::sin(first + second * t[i]) + std::sin(first - 7 * second * t[i]) / 3;
    return mean + amplitude * (wave + noise * (part(random) - 0.5));
  });
}

/// A run in time of one kind of load, on a contact that changes with every other seed.
LoadHistory generated_run(unsigned seed, double noise) {
  std::mt19937 random(seed);
  std::exponential_distribution<double> gap(1);
  VectorXd t(60);
  double sum = 0;
  for (double& time : t) time = sum += 0.01 + 0.1 * gap(random);
  RunRows rows;
  rows.time = t;
  rows.velocity = waves(t, 2, 0.5, noise, random);
  if (seed % 3 == 0) rows.force = waves(t, 0, 0.3, noise, random);
  if (seed % 3 == 1) rows.creepage = waves(t, 0.1, 0.2, noise, random);
  if (seed % 3 == 2) {
    rows.angular_velocity = VectorXd(*rows.velocity / 5 + waves(t, 0, 0.02, noise, random));
    rows.radius = 5;
  }
  if (seed % 4 == 1) rows.normal_load = waves(t, 1, 0.4, noise, random).cwiseMax(0.3);
  if (seed % 4 == 3) rows.peak_traction = waves(t, 1, 0.2, noise, random);
  return LoadHistory(rows);
}

double value_of(const Load& load) { return Prescribed(load).value; }

/// The largest part of the tolerance that the load differs by from its line over a step.
double bend(const LoadHistory& loads, const LoadTolerance& tolerance, double from, double to) {
  const bool under_force = Prescribed(loads.at(from)).by_force;
  const ContactScale first = loads.contact_at(from), last = loads.contact_at(to);
  constexpr int places = 50;
  double largest = 0;
  for (int k = 1; k < places; ++k) {
    const double part = static_cast<double>(k) / places;
    const double at = std::lerp(from, to, part);
    const ContactScale scale = loads.contact_at(at);
    const double load =
        under_force ? (value_of(loads.at(at)) -
                       std::lerp(value_of(loads.at(from)), value_of(loads.at(to)), part)) /
                          tolerance.force
                    : (at - from) *
                          (value_of(loads.between(from, at)) - value_of(loads.between(from, to))) /
                          tolerance.shift;
    const double size = scale.half_width - std::lerp(first.half_width, last.half_width, part);
    const double bound = scale.bound - std::lerp(first.bound, last.bound, part);
    largest = std::max({largest, std::abs(load), std::abs(size) / tolerance.contact,
                        std::abs(bound) / tolerance.contact});
  }
  return largest;
}

TEST(StraightSteps, AreStraightWithinTheToleranceAndNoShorter) {
  double pairs = 0, needed = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    const LoadHistory loads = generated_run(seed, 0.1);
    for (const double part : {0.1, 1e-2, 1e-3}) {
      const LoadTolerance tolerance{.shift = part, .force = part, .contact = part};
      const auto lengths = straight_steps(loads, tolerance, unlimited, million);
      ASSERT_TRUE(lengths);
      double before = 0, at = 0, worst = 0;
      for (const double length : *lengths) {
        const double end = std::min(at + length, loads.distance());
        worst = std::max(worst, bend(loads, tolerance, at, end));
        pairs += at > 0 ? 1 : 0;
        if (at > 0) needed += bend(loads, tolerance, before, end) > 0.5 ? 1 : 0;
        before = at;
        at = end;
      }
      EXPECT_NEAR(at / loads.distance(), 1, 1e-12);
      EXPECT_LE(worst, 1.001);
    }
  }
  EXPECT_GE(needed, 0.8 * pairs) << "two would do as one";
}

TEST(StraightSteps, OfAStraightLoadAreOne) {
  RunRows rows;
  rows.distance = VectorXd::LinSpaced(1000, 2, 9);
  rows.force = VectorXd::LinSpaced(1000, -1, 0.5);
  const LoadTolerance tolerance{.shift = 1e-6, .force = 1e-6, .contact = 1e-6};
  const auto lengths = straight_steps(LoadHistory(rows), tolerance, unlimited, million);
  ASSERT_TRUE(lengths);
  ASSERT_EQ(lengths->size(), 1U);
  EXPECT_NEAR(lengths->front(), 7, 1e-14);
}

TEST(StraightSteps, AreNoLongerThanTheLongest) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const LoadHistory loads = generated_run(seed, 0);
    const auto lengths =
        straight_steps(loads, {.shift = 1, .force = 1, .contact = 1}, 0.013, million);
    ASSERT_TRUE(lengths);
    for (const double length : *lengths) EXPECT_LE(length, 0.013 * (1 + 1e-8));
    EXPECT_LE(static_cast<double>(lengths->size()), 4 * loads.distance() / 0.013);
  }
}

TEST(StraightSteps, EndWhereTheyAreTooMany) {
  const LoadHistory loads = generated_run(1, 0.1);
  const LoadTolerance fine{.shift = 1e-9, .force = 1e-9, .contact = 1e-9};
  EXPECT_FALSE(straight_steps(loads, fine, unlimited, 1000));
  EXPECT_FALSE(straight_steps(loads, fine, 1e-300, 1000));
}

/// Where the load is lost, a root of the normal load is infinitely steep.
TEST(StraightSteps, FollowAContactThatIsLost) {
  RunRows rows;
  rows.distance = Eigen::Vector4d(0, 1, 2, 3);
  rows.creepage = Eigen::Vector4d(0, 0, 0, 0);
  rows.normal_load = Eigen::Vector4d(1, 0, 0, 1);
  const LoadHistory loads(rows);
  const LoadTolerance tolerance{.shift = 1, .force = 1, .contact = 1e-4};
  const auto lengths = straight_steps(loads, tolerance, unlimited, million);
  ASSERT_TRUE(lengths);
  EXPECT_LT(lengths->size(), 400U);
  double at = 0;
  for (const double length : *lengths) {
    EXPECT_LE(bend(loads, tolerance, at, std::min(3.0, at + length)), 1.01);
    at += length;
  }
}

struct Rolled {
  VectorXd distance, force, creep;
};

Rolled roll(const TransientProblem& problem, const LoadHistory& loads,
            const std::vector<double>& lengths) {
  const Load first = loads.at(0);
  const auto* force_at_start = std::get_if<PrescribedForce>(&first);
  const Start start =
      force_at_start == nullptr ? Start(Rest{}) : CattaneoShift{force_at_start->value};
  TransientRolling rolling(problem, start, loads.contact_at(0));
  std::vector<double> q = {0}, force = {rolling.state().force}, creep = {0};
  rolling.roll(loads.distance(), lengths, loads, [&](const TransientState& state) {
    creep.push_back(creep.back() + state.creepage * (state.distance - q.back()));
    q.push_back(state.distance);
    force.push_back(state.force);
  });
  const auto n = static_cast<Index>(q.size());
  return {VectorXd::Map(q.data(), n), VectorXd::Map(force.data(), n),
          VectorXd::Map(creep.data(), n)};
}

// The error of the force, over full sliding, and of the shift likewise, is below the tolerance.
// Under a force, creepages of steps far below an element differ by more than the finest tolerance.
TEST(StraightSteps, GiveTheResultsOfShortOnes) {
  const TransientProblem problem{
      .contact = {PlaneKernel(Material{.shear_modulus = 1, .poisson_ratio = 0.28}, 20),
                  HertzBound(1, 0.6)},
      .grid = Grid({.half_width = 1, .elements = 30}),
      .basis = constant_basis(),
      .scheme = Remembered{}};
  const double full = full_sliding_force(problem.contact.bound);
  const double soft = full / stiffness(problem);
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const LoadHistory loads = generated_run(seed, 0.1);
    const Rolled fine = roll(problem, loads, {problem.grid.spacing() / 50});
    for (const double part : {0.1, 1e-2, 1e-3}) {
      const auto lengths = straight_steps(
          loads, {.shift = part * soft, .force = part * full, .contact = part}, unlimited, million);
      ASSERT_TRUE(lengths);
      const Rolled rolled = roll(problem, loads, *lengths);
      double worst_force = 0, worst_creep = 0;
      for (Index i = 0; i < rolled.distance.size(); ++i) {
        const double force = interpolated(fine.distance, fine.force, rolled.distance[i]);
        const double creep = interpolated(fine.distance, fine.creep, rolled.distance[i]);
        worst_force = std::max(worst_force, std::abs(rolled.force[i] - force) / full);
        worst_creep = std::max(worst_creep, std::abs(rolled.creep[i] - creep) / soft);
      }
      const double of_reference = seed % 3 == 0 ? 2e-3 : 0;
      EXPECT_LE(worst_force, 0.3 * part + of_reference);
      EXPECT_LE(worst_creep, 0.3 * part + of_reference);
    }
  }
}

}  // namespace microslip::straight_steps_test
