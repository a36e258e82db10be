// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds that are rough at all scales, with many stick zones, against direct sums over all
// elements.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "microslip/friction/rough_bound.hpp"
#include "microslip/rolling/target_error.hpp"
#include "property/samples.hpp"

namespace microslip::rough_contacts_test {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Material material{1.44, 0.28};
const HertzBound hertz(1, 1);

SteadyProblem problem_of(const TractionBound& bound, Index elements, double force_ratio) {
  return {.contact = {PlaneKernel(material, 20), bound},
          .grid = Grid({.half_width = 1, .elements = elements}),
          .method = Calibrated{},
          .load = PrescribedForce{-force_ratio * full_sliding_force(bound)}};
}

Index stick_zones(const SteadySolution& solution) {
  Index count = 0;
  Zone before = Zone::slip_negative;
  for (const Zone zone : solution.zones) {
    count += zone == Zone::adhesion && before != Zone::adhesion ? 1 : 0;
    before = zone;
  }
  return count;
}

/// u(x + dx) - u(x), over dx, by the closed form of the integral of the logarithm over elements.
double strain_ahead(double x, double dx, const SteadySolution& solution) {
  const double k = 2 * (1 - material.poisson_ratio) / (std::numbers::pi * material.shear_modulus);
  const auto integral = [](double z) { return z == 0 ? 0 : z * std::log(std::abs(z)); };
  const auto over = [&](double from, double to, double at) {
    return integral(at - from) - integral(at - to);
  };
  double sum = 0;
  for (Index j = 0; j < solution.x.size(); ++j) {
    const double from = solution.x[j] - dx / 2, to = solution.x[j] + dx / 2;
    sum -= k * solution.traction[j] * (over(from, to, x + dx) - over(from, to, x));
  }
  return sum / dx;
}

/// A - A' is positive definite, so that only one solution meets the conditions.
void expect_contact_conditions(const SteadySolution& solution, double force) {
  const Index n = solution.x.size();
  const double dx = solution.x[1] - solution.x[0];
  const double slip_scale = std::abs(solution.creepage);
  const double bound_scale = solution.bound.maxCoeff();
  for (Index i = 0; i < n; ++i) {
    const double p = solution.traction[i], g = solution.bound[i];
    const double slip = solution.creepage - strain_ahead(solution.x[i], dx, solution);
    ASSERT_LE(std::abs(p), g + 1e-10 * bound_scale) << i;
    if (solution.zones[static_cast<std::size_t>(i)] == Zone::adhesion) {
      ASSERT_NEAR(slip, 0, 1e-8 * slip_scale) << i;
    } else {
      ASSERT_NEAR(std::abs(p), g, 1e-12 * bound_scale) << i;
      ASSERT_LE(g > 0 ? slip * p : 0, 1e-8 * slip_scale * bound_scale) << i;
    }
  }
  EXPECT_NEAR(solution.force / force, 1, 1e-9);
}

TEST(RoughContacts, MeetTheContactConditions) {
  std::mt19937 random(20261124);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  Index most_zones = 0;
  for (int k = 0; k < 40; ++k) {
    const Roughness roughness{.amplitude = uniform(0.05, 1.5),
                              .hurst = uniform(0.1, 0.9),
                              .seed = static_cast<unsigned>(k),
                              .rows = 4097};
    const auto elements = static_cast<Index>(uniform(200, 900));
    const SteadyProblem problem = problem_of(rough_bound(hertz, roughness), elements,
                                             std::exp(uniform(std::log(0.01), std::log(0.98))));
    const SteadySolution solution = solve_steady(problem);
    SCOPED_TRACE(testing::Message() << k << ": N = " << elements << ", H = " << roughness.hurst);
    expect_contact_conditions(solution, std::get<PrescribedForce>(problem.load).value);
    EXPECT_LT(solution.evidence.violation(), 1e-9);
    most_zones = std::max(most_zones, stick_zones(solution));
  }
  EXPECT_GT(most_zones, 10);
}

// Before both kinds of violations were exchanged at once, the second of these took minutes.
TEST(RoughContacts, NumberOfRoundsDoesNotGrowWithTheNumberOfZones) {
  for (const double force_ratio : {0.05, 0.5, 0.95}) {
    const TractionBound bound = rough_bound(hertz, {.amplitude = 0.5, .hurst = 0.3, .rows = 16385});
    for (const Index elements : {2000, 16000}) {
      const SteadySolution solution = solve_steady(problem_of(bound, elements, force_ratio));
      EXPECT_LE(solution.iterations, 8) << force_ratio;
      EXPECT_GT(stick_zones(solution), elements / 1000) << force_ratio;
    }
  }
}

// The truth is known to its difference to half as many elements.
TEST(RoughContacts, EstimatesHold) {
  constexpr double target = 2e-3;
  constexpr Index elements = 32768;
  constexpr std::array hursts{0.3, 0.5, 0.1};
  for (int i = 0; i < samples(3); ++i) {
    for (const double force_ratio : {0.5, 0.02, 0.9}) {
      if (force_ratio != 0.5 && !takes_all_samples()) continue;
      const double hurst = hursts.at(static_cast<std::size_t>(i));
      const TractionBound bound =
          rough_bound(hertz, {.amplitude = 0.3, .hurst = hurst, .seed = 7, .rows = 8193});
      const SteadyProblem problem = problem_of(bound, elements, force_ratio);
      const EstimatedSteady found =
          solve_steady_to({{problem.contact.kernel, bound}, problem.load}, target);
      const double truth = solve_steady(problem).creepage;
      const double other = solve_steady(problem_of(bound, elements / 2, force_ratio)).creepage;
      EXPECT_LE(found.error, target);
      EXPECT_LE(std::abs(found.solution.creepage / truth - 1),
                found.error + std::abs(other / truth - 1))
          << hurst << ", " << force_ratio;
    }
  }
}

// Gaps of the contact that are shorter than elements make creepages wrong by a fifth: a warning
// says so.
TEST(RoughContacts, UnresolvedGapsAreDoubted) {
  for (const double force_ratio : {1e-6, 1e-3}) {
    const TractionBound bound = rough_bound(hertz, {.amplitude = 1.5, .hurst = 0.3, .rows = 1025});
    const SteadySolution found = solve_steady(problem_of(bound, 51, force_ratio));
    const double truth = solve_steady(problem_of(bound, 8192, force_ratio)).creepage;
    ASSERT_GT(std::abs(found.creepage / truth - 1), 0.1);
    EXPECT_TRUE(doubt_of(found.evidence, Acceptance{}, true).has_value());
  }
}

// Among 290 contacts like these, with 10 to 400 elements, 5 creepages were wrong by more than 10 %
// without a warning at the limit 0.05, and 2 at 0.02, with 10 and 12 elements. An error below 1 %
// was warned of in 5.
TEST(RoughContacts, LargeErrorsAreDoubted) {
  std::mt19937 random(7);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  int large = 0, needless = 0;
  for (unsigned k = 0; k < 60; ++k) {
    const TractionBound bound = rough_bound(hertz, {.amplitude = uniform(0.5, 1.5),
                                                    .hurst = uniform(0.1, 0.5),
                                                    .seed = k,
                                                    .rows = k % 2 == 0 ? 129 : 1025});
    const double force_ratio = std::exp(uniform(std::log(1e-6), std::log(0.98)));
    const auto elements = static_cast<Index>(std::exp(uniform(std::log(25), std::log(100))));
    const SteadySolution found = solve_steady(problem_of(bound, elements, force_ratio));
    const double truth = solve_steady(problem_of(bound, 2048, force_ratio)).creepage;
    const double error = std::abs(found.creepage / truth - 1);
    const bool doubted = doubt_of(found.evidence, Acceptance{}, true).has_value();
    EXPECT_TRUE(doubted || error < 0.1) << k << ": N = " << elements << ", " << error;
    large += error >= 0.1 ? 1 : 0;
    needless += doubted && error < 0.01 ? 1 : 0;
  }
  EXPECT_GE(large, 3);
  EXPECT_LE(needless, 4);
}

}  // namespace microslip::rough_contacts_test
