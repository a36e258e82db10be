// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that falls with slip in contact ellipses, for generated laws and motions: Coulomb's limit,
// the equations at each cell, mirror images and units, full sliding in closed form, line contacts in
// the rows of a wide ellipse, steps of other lengths, and saved states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/support/not_converged.hpp"
#include "samples.hpp"

namespace microslip::falling_patch_test {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

struct Case {
  SteadyPatch patch;
  Vector3d motion;
};

PatchLoad motions(const Vector3d& values) {
  return {{{false, values[0]}, {false, values[1]}, {false, values[2]}}};
}

/// Shear modulus, peak and size are 1, so that creepages of 1 and more slide. Laws fall slowly enough
/// that steady rolling has one solution.
std::vector<Case> generated_cases(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::vector<Case> cases;
  for (int i = 0; i < count; ++i) {
    const double ratio = std::exp(uniform(-1.2, 1.2));
    SteadyPatch patch{.material = {1, uniform(0, 0.5)},
                      .bound = EllipticBound(std::sqrt(ratio), 1 / std::sqrt(ratio), 1),
                      .rows = 7,
                      .elements = 8};
    const FrictionLaw law(static_cast<FrictionLaw::Form>(i % 3), uniform(0.2, 0.95), 1);
    patch.friction = SlipFriction{.law = law, .speed = uniform(0.1, 0.5) / law.steepest()};
    if (i % 2 == 1) patch.friction->memory_length = uniform(0.05, 2);
    const Vector3d motion(uniform(-2, 2), uniform(-2, 2), uniform(-1, 1));
    patch.load = motions(motion);
    cases.push_back({patch, motion});
  }
  return cases;
}

VectorXd norms(const Eigen::MatrixX2d& vectors) { return vectors.rowwise().norm(); }

double difference(const Vector3d& one, const Vector3d& other, const SteadyPatch& patch) {
  return (one - other).cwiseAbs().maxCoeff() / patch.bound.total();
}

TEST(FallingPatch, IsCoulombsWhereItDoesNotFall) {
  for (Case of : generated_cases(1, samples(12))) {
    SteadyPatch coulomb = of.patch;
    coulomb.friction.reset();
    const Vector3d expected = solve_steady(coulomb).resultants;
    of.patch.friction->law = FrictionLaw(FrictionLaw::Form::exponential, 1, 1);
    EXPECT_LT(difference(solve_steady(of.patch).resultants, expected, coulomb), 1e-9);
    of.patch.friction->law = FrictionLaw(FrictionLaw::Form::rational, 0.3, 1);
    of.patch.friction->memory_length = 1e12;
    EXPECT_LT(difference(solve_steady(of.patch).resultants, expected, coulomb), 1e-9);
  }
}

// In cells that begin to slip, the slip of the law is not yet that at the centre, but less. Where the
// slip turns within a cell, its traction is the mean of directions, and below the bound.
TEST(FallingPatch, KeepsItsLawInEachCell) {
  int slipping = 0, sticking = 0, beginning = 0, turning = 0;
  for (Case& of : generated_cases(2, samples(24))) {
    of.patch.friction->memory_length = 0;
    const SteadyPatchSolution found = solve_steady(of.patch);
    SteadyPatch coulomb = of.patch;
    coulomb.friction.reset();
    const VectorXd at_rest = solve_steady(coulomb).bound;
    const VectorXd slips = norms(found.slip), tractions = norms(found.traction);
    for (Index i = 0; i < at_rest.size(); ++i) {
      const double bound = at_rest[i] * of.patch.friction->law(of.patch.friction->speed * slips[i]);
      EXPECT_GE(found.bound[i], bound - 1e-7);
      EXPECT_LE(found.bound[i], at_rest[i] + 1e-15);
      EXPECT_LE(tractions[i], found.bound[i] + 1e-7);
      if (!found.slips[static_cast<std::size_t>(i)]) {
        EXPECT_EQ(found.bound[i], at_rest[i]);
        ++sticking;
        continue;
      }
      ++(found.bound[i] < bound + 1e-7 ? slipping : beginning);
      if (tractions[i] < found.bound[i] - 1e-7) ++turning;
      EXPECT_LT(found.traction.row(i).dot(found.slip.row(i)), -0.98 * tractions[i] * slips[i]);
    }
    EXPECT_FALSE(found.has_second);
    EXPECT_GT(found.dissipation, 0);
  }
  EXPECT_GT(slipping, 10 * beginning);
  EXPECT_GT(slipping, 20 * turning);
  EXPECT_GT(sticking, 15);
}

TEST(FallingPatch, HasMirrorImagesAndUnits) {
  for (const Case& of : generated_cases(3, samples(12))) {
    const Vector3d found = solve_steady(of.patch).resultants;
    SteadyPatch mirrored = of.patch;
    mirrored.load = motions(of.motion.cwiseProduct(Vector3d(1, -1, -1)));
    const Vector3d image = solve_steady(mirrored).resultants.cwiseProduct(Vector3d(1, -1, -1));
    EXPECT_LT(difference(image, found, of.patch), 1e-7);
    // Lengths 3 times as large, tractions 5, the shear modulus 50, and speeds 7.
    SteadyPatch scaled = of.patch;
    const double ratio = of.patch.bound.ratio();
    scaled.material.shear_modulus = 50;
    scaled.bound = EllipticBound(3 * std::sqrt(ratio), 3 / std::sqrt(ratio), 5);
    scaled.load = motions((of.motion / 10).cwiseProduct(Vector3d(1, 1, 1.0 / 3)));
    SlipFriction& friction = *scaled.friction;
    friction.speed *= 10;
    friction.memory_length *= 3.0 / 10;
    const Vector3d larger =
        solve_steady(scaled).resultants.cwiseProduct(Vector3d(1, 1, 1.0 / 3) / (5 * 3 * 3));
    EXPECT_LT(difference(larger, found, of.patch), 1e-7);
  }
}

TEST(FallingPatch, ForcesAndCreepagesLeadToEachOther) {
  for (Case& of : generated_cases(4, samples(12))) {
    of.patch.load = motions(of.motion / 4);  // on the rising side of the curve
    const SteadyPatchSolution by_motion = solve_steady(of.patch);
    SteadyPatch driven = of.patch;
    driven.load[0] = {.by_resultant = true, .value = by_motion.resultants[0]};
    driven.load[2] = {.by_resultant = true, .value = by_motion.resultants[2]};
    const SteadyPatchSolution by_force = solve_steady(driven);
    EXPECT_LT((by_force.motion - by_motion.motion).cwiseAbs().maxCoeff(), 1e-5);
  }
}

// Errors are those of twice as many rows and elements, which are a quarter of them or less.
TEST(FallingPatch, HasErrorsBelowTheirEstimates) {
  for (Case& of : generated_cases(9, samples(30))) {
    of.patch.rows = 8;
    of.patch.elements = 10;
    const SteadyPatchSolution found = solve_steady_with_change(of.patch);
    SteadyPatch fine = of.patch;
    fine.rows *= 2;
    fine.elements *= 2;
    const double error = difference(found.resultants, solve_steady(fine).resultants, of.patch);
    EXPECT_LT(error, 2e-3 + 1.5 * found.evidence.change);
    EXPECT_LT(error, 1e-2);
  }
}

// At a slip that is much larger than elastic strains, all of it is the creepage. With a memory d, the
// ratio of material that came in s before is k + (1 - k) exp(-s xi/d), with the law's k; at the start
// of rolling the material that is in the contact has slipped over the way q only.
double sliding_force(double ratio, double kinetic, double slip_over_memory, double q) {
  constexpr int parts = 400;
  const double a = std::sqrt(ratio), b = 1 / a;
  double force = 0;
  for (int i = 0; i < parts; ++i) {
    const double psi = pi * ((i + 0.5) / parts - 0.5), half = a * std::cos(psi);
    for (int j = 0; j < parts; ++j) {
      const double theta = pi * (j + 0.5) / parts;
      const double way = std::min(q, half * (1 - std::cos(theta)));
      const double fallen = kinetic + (1 - kinetic) * std::exp(-slip_over_memory * way);
      force +=
          fallen * std::cos(psi) * std::sin(theta) * half * std::sin(theta) * b * std::cos(psi);
    }
  }
  return force * (pi / parts) * (pi / parts);
}

SteadyPatch sliding_ellipse(double ratio, double creepage, double kinetic, double memory) {
  SteadyPatch patch{.material = {1e6, 0.28},
                    .bound = EllipticBound(std::sqrt(ratio), 1 / std::sqrt(ratio), 1),
                    .rows = 12,
                    .elements = 16,
                    .load = motions({creepage, 0, 0})};
  patch.friction = SlipFriction{
      .law = {VectorXd{{0, 1e-4}}, VectorXd{{1, kinetic}}}, .speed = 1, .memory_length = memory};
  return patch;
}

TEST(FallingPatch, HasTheForceOfFullSlidingInClosedForm) {
  for (const double ratio : {0.4, 2.5}) {
    for (const double memory : {0.0, 0.002, 0.02}) {
      const double creepage = 0.01, kinetic = 0.35;
      const SteadyPatch patch = sliding_ellipse(ratio, creepage, kinetic, memory);
      const double per_memory = memory > 0 ? creepage / memory : 1e9;
      const double expected = sliding_force(ratio, kinetic, per_memory, 1e9);
      const double tolerance = memory > 0 ? 3e-3 : 1e-4;
      EXPECT_NEAR(solve_steady(patch).resultants[0] / patch.bound.total(),
                  -expected / patch.bound.total(), tolerance)
          << ratio << ' ' << memory;
    }
  }
}

TEST(FallingPatch, FallsFromTheStartInClosedFormInStepsOfAnyLength) {
  const double ratio = 1.6, creepage = 0.01, kinetic = 0.35, memory = 0.01;
  const SteadyPatch patch = sliding_ellipse(ratio, creepage, kinetic, memory);
  for (const double dq : {0.03, 0.1, 0.4}) {
    PatchRolling rolling(patch);
    for (int i = 1; rolling.distance() < 4; ++i) {
      rolling.roll(dq, patch.load);
      if (i % std::max(1, static_cast<int>(0.4 / dq)) != 0) continue;
      const double expected = sliding_force(ratio, kinetic, creepage / memory, rolling.distance());
      EXPECT_NEAR(-rolling.resultants()[0] / patch.bound.total(), expected / patch.bound.total(),
                  4e-3)
          << dq << ' ' << rolling.distance();
    }
  }
}

// A contact that shrinks at once keeps the material in its middle, which has the ratios by its way
// through the larger contact.
TEST(FallingPatch, KeepsTheFrictionOfMaterialInAContactThatShrinks) {
  const double ratio = 1.6, creepage = 0.01, kinetic = 0.35, memory = 0.01, size = 0.6;
  const SteadyPatch patch = sliding_ellipse(ratio, creepage, kinetic, memory);
  PatchRolling rolling(patch);
  for (int i = 0; i < 60; ++i) rolling.roll(0.1, patch.load);
  rolling.set_contact({.half_width = size, .bound = size});
  rolling.roll(1e-3, patch.load);
  constexpr int parts = 400;
  const double a = std::sqrt(ratio), b = 1 / a;
  double force = 0, full = 0;
  for (int i = 0; i < parts; ++i) {
    const double y = b * size * (2 * (i + 0.5) / parts - 1);
    const double larger = a * std::sqrt(1 - y * y / (b * b));
    for (int j = 0; j < parts; ++j) {
      const double x = a * size * (2 * (j + 0.5) / parts - 1);
      const double square = 1 - (x * x / (a * a) + y * y / (b * b)) / (size * size);
      if (square <= 0) continue;
      full += std::sqrt(square);
      force += std::sqrt(square) *
               (kinetic + (1 - kinetic) * std::exp(-creepage / memory * (larger - x)));
    }
  }
  EXPECT_NEAR(-rolling.resultants()[0] / rolling.full_sliding(), force / full, 5e-3);
}

// Each row of an ellipse that is narrow along the rolling is a line contact.
SteadyPatch wide_ellipse(const SlipFriction& friction) {
  SteadyPatch patch{
      .material = {1, 0.3}, .bound = EllipticBound(1, 1000, 1), .rows = 8, .elements = 40};
  patch.friction = friction;
  return patch;
}

SteadyProblem line_of(const SteadyPatch& patch, double cosine, double creepage) {
  SteadyProblem line{
      .contact = {PlaneKernel(patch.material, 100 * cosine), HertzBound(cosine, cosine)},
      .grid = Grid({.half_width = cosine, .elements = 101}),
      .method = Calibrated{},
      .load = PrescribedCreepage{creepage}};
  line.friction = patch.friction;
  return line;
}

/// The sum of the rows' forces over full sliding.
template <class ForceOfRow>
double sum_of_rows(const SteadyPatch& patch, const ForceOfRow& force) {
  double sum = 0, full = 0;
  for (Index k = 0; k < patch.rows; ++k) {
    const double psi =
        pi * ((static_cast<double>(k) + 0.5) / static_cast<double>(patch.rows) - 0.5);
    const double cosine = std::cos(psi);
    sum += cosine * force(cosine);
    full += cosine * HertzBound(cosine, cosine).total();
  }
  return sum / full;
}

TEST(FallingPatch, IsALineContactInEachRowOfAWideEllipse) {
  for (const double memory : {0.0, 0.3}) {
    const SlipFriction friction{
        .law = {FrictionLaw::Form::exponential, 0.3, 0.5}, .speed = 1, .memory_length = memory};
    SteadyPatch patch = wide_ellipse(friction);
    for (const double creepage : {0.3, 0.7, 1.5}) {
      patch.load = motions({creepage, 0, 0});
      const double expected = sum_of_rows(patch, [&](double cosine) {
        return solve_steady(line_of(patch, cosine, creepage)).force;
      });
      EXPECT_NEAR(solve_steady(patch).resultants[0] / patch.bound.total(), expected, 3e-3)
          << memory << ' ' << creepage;
    }
  }
}

TEST(FallingPatch, TurnsToSteadyRollingInStepsOfAnyLength) {
  for (Case& of : generated_cases(5, samples(6))) {
    of.patch.friction->memory_length = 1;
    const Vector3d steady = solve_steady(of.patch).resultants;
    const double a = of.patch.bound.half_width();
    for (const double step : {0.1, 0.37}) {
      PatchRolling rolling(of.patch);
      while (rolling.distance() < 8 * a) rolling.roll(step * a, of.patch.load);
      EXPECT_LT(difference(rolling.resultants(), steady, of.patch), 6e-3) << step;
      EXPECT_GE(rolling.dissipation(), 0);
    }
  }
}

// A memory of 2 (1 - k) a g/G is enough, whatever the speed; a much shorter one is not.
TEST(FallingPatch, HasOneSolutionOfShortStepsWithALongMemory) {
  int doubled = 0, doubled_with_less = 0;
  for (Case& of : generated_cases(10, samples(9))) {
    SlipFriction& friction = *of.patch.friction;
    friction.speed *= 10;
    const double kinetic = friction.law(std::numeric_limits<double>::infinity());
    const double a = of.patch.bound.half_width(), enough = 2 * (1 - kinetic) * a;
    for (const double memory : {enough, enough / 50}) {
      friction.memory_length = memory;
      PatchRolling rolling(of.patch);
      for (int i = 0; i < 40; ++i) {
        rolling.roll(0.05 * a, of.patch.load);
        (memory == enough ? doubled : doubled_with_less) += rolling.has_second() ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(doubled, 0);
  EXPECT_GT(doubled_with_less, 3);
}

TEST(FallingPatch, FollowsAContactThatGrowsAndShrinks) {
  for (Case& of : generated_cases(6, samples(6))) {
    of.patch.friction->memory_length = 1;
    PatchRolling slow(of.patch, {.half_width = 0.5, .bound = 0.5});
    for (int i = 0; i < 30; ++i) slow.roll(0.2, of.patch.load);
    for (int i = 0; i < 30; ++i) {
      const double size = 0.5 + 0.5 * (i + 1) / 30;
      slow.set_contact({.half_width = size, .bound = size});
      slow.roll(0.2, of.patch.load);
    }
    for (int i = 0; i < 30; ++i) slow.roll(0.2, of.patch.load);
    EXPECT_LT(difference(slow.resultants(), solve_steady(of.patch).resultants, of.patch), 1e-2);
    slow.set_contact({.half_width = 0, .bound = 0});
    slow.roll(0.1, of.patch.load);
    slow.set_contact({});
    PatchRolling fresh(of.patch, {.half_width = 0, .bound = 0});
    fresh.set_contact({});
    slow.roll(0.3, of.patch.load);
    fresh.roll(0.3, of.patch.load);
    EXPECT_LT(difference(slow.resultants(), fresh.resultants(), of.patch), 1e-9);
  }
}

TEST(FallingPatch, GoesOnFromSavedStatesAndCopies) {
  for (Case& of : generated_cases(7, samples(6))) {
    PatchRolling rolling(of.patch);
    rolling.set_speed(0.7 * of.patch.friction->speed);
    for (int i = 0; i < 6; ++i) rolling.roll(0.13, of.patch.load);
    PatchRolling copy = rolling, restored(of.patch);
    restored.restore({rolling.save()});
    for (PatchRolling* one : {&rolling, &copy, &restored}) {
      for (int i = 0; i < 4; ++i) one->roll(0.21, of.patch.load);
    }
    EXPECT_EQ(copy.tractions(), rolling.tractions());
    EXPECT_EQ(restored.tractions(), rolling.tractions());
    EXPECT_EQ(restored.evidence().dissipated, rolling.evidence().dissipated);
    EXPECT_EQ(restored.save(), rolling.save());
  }
}

TEST(FallingPatch, RefusesWhatItDoesNotSolve) {
  const Case of = generated_cases(8, 1).front();
  PatchRolling rolling(of.patch);
  rolling.shift(motions({0.1, 0, 0}));
  rolling.roll(0.1, of.patch.load);
  EXPECT_THROW(rolling.shift(motions({0.1, 0, 0})), std::invalid_argument);
  EXPECT_THROW(rolling.roll(-0.1, of.patch.load), std::invalid_argument);
  EXPECT_THROW(rolling.jacobian(), std::invalid_argument);
  EXPECT_THROW(rolling.set_speed(0), std::invalid_argument);
  SteadyPatchSolver solver(of.patch);
  solver.solve(of.patch.load);
  EXPECT_THROW(solver.jacobian(), std::invalid_argument);
  SteadyPatch other = of.patch;
  other.friction->speed *= 2;
  EXPECT_THROW(PatchRolling(other).restore({rolling.save()}), std::invalid_argument);
  // Friction carries the force where the bodies stick, and not where they slip.
  SteadyPatch held = of.patch;
  held.friction = SlipFriction{.law = {FrictionLaw::Form::linear, 0.1, 1e-3}, .speed = 1};
  held.load[0] = {.by_resultant = true, .value = 0.9 * held.bound.total()};
  EXPECT_THROW(solve_steady(held), NotConverged);
}

}  // namespace microslip::falling_patch_test
