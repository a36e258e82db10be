// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/target_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "microslip/friction/rough_bound.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::target_error_test {

constexpr Material material{82000, 0.28};

/// True errors over their estimates.
struct Honesty {
  std::vector<double> ratios;

  /// Part of them that is below its estimate.
  double covered() const {
    const auto below = std::count_if(ratios.begin(), ratios.end(), [](double r) { return r <= 1; });
    return static_cast<double>(below) / static_cast<double>(ratios.size());
  }

  double median() {
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
  }
};

// Carter's problem, the exact solution of which is known: parts of adhesion, loads and targets at
// random.
TEST(LongRunsOfTargetErrors, AreHonestForCarter) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.02, 0.98), exponent(-9, -1);
  Honesty honesty;
  for (int i = 0; i < 200; ++i) {
    const double stick = part(random);
    const HertzBound bound(5, 300);
    const double slope = 2 * (1 - 0.28) / 82000 * 300 / 5;  // strain per mm from the centre
    const double creepage = slope * 5 * (1 - stick);
    const double force = -1.5 * std::numbers::pi * 500 * (1 - stick * stick);
    const bool by_force = i % 2 == 0;
    const Load load = by_force ? Load(PrescribedForce{force}) : Load(PrescribedCreepage{creepage});
    const double target = std::pow(10, exponent(random));
    const EstimatedSteady found =
        solve_steady_to({{PlaneKernel(material, 10), bound}, load}, target);
    EXPECT_LE(found.error, target);
    const double exact = by_force ? creepage : force;
    honesty.ratios.push_back(std::abs(answer_of(load, found.solution) / exact - 1) / found.error);
  }
  EXPECT_EQ(honesty.covered(), 1);
}

// By elements alone, against inversion.
TEST(LongRunsOfTargetErrors, AreHonestForElements) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0.02, 0.98), exponent(-4, -1), bend(-0.25, 0.25);
  Honesty honesty;
  for (int i = 0; honesty.ratios.size() < 200; ++i) {
    const Kernel kernel =
        i % 3 == 0 ? Kernel(PlaneKernel(material, 10)) : StripKernel(material, 20);
    const PolynomialBound bound(5, 300, Eigen::Vector3d(1, bend(random), bend(random)));
    const double full = full_sliding_force(bound);
    const Load load = PrescribedForce{-full * (1 - std::pow(part(random), 2))};
    const double target = std::pow(10, exponent(random));
    const EstimatedSteady found = estimate_by_elements({{kernel, bound}, load}, target);
    EXPECT_LE(found.error, target);
    const InvertedSolution exact = InvertedRolling(kernel, bound).solve(load);
    if (!exact.keeps_conditions()) continue;  // a second stick zone
    honesty.ratios.push_back(std::abs(found.solution.creepage / exact.creepage() - 1) /
                             found.error);
  }
  EXPECT_GE(honesty.covered(), 0.95);
  EXPECT_GE(honesty.median(), 0.03);
}

TEST(TargetError, PicksInversionWhereItMayAndElementsWhereItMayNot) {
  const Load load = PrescribedForce{-1500};
  const auto picked = [&](const TractionBound& bound, const Kernel& kernel) {
    return solve_steady_to({{kernel, bound}, load}, 1e-3).solution.scheme;
  };
  const HertzBound hertz(5, 300);
  const Eigen::VectorXd x =
      -5 * Eigen::VectorXd::LinSpaced(201, 0, 3.14159265358979312).array().cos();
  const TabulatedBound table(5, x, bound_at(hertz, x));
  const PolynomialBound dented(5, 1500, Eigen::Vector3d(0.05, 0, 1));
  EXPECT_EQ(picked(hertz, StripKernel(material, 10)), SteadyScheme::inversion);
  EXPECT_EQ(picked(table, PlaneKernel(material, 10)), SteadyScheme::inversion);
  EXPECT_EQ(picked(dented, PlaneKernel(material, 10)), SteadyScheme::inversion);
  EXPECT_EQ(picked(dented, LayeredKernel(PlaneKernel(material, 10), 1e-6)),
            SteadyScheme::calibrated);
}

// A hard layer, which has no inversion; several stick zones, and a target between.
TEST(TargetError, ReachesItsTargetWithSeveralStickZones) {
  const SteadyContact contact{{LayeredKernel(PlaneKernel(material, 10), 1e-6),
                               PolynomialBound(5, 300, Eigen::Vector3d(0.05, 0, 1))},
                              PrescribedForce{-0.075 * std::numbers::pi * 5 * 300}};
  const EstimatedSteady coarse = solve_steady_to(contact, 1e-2);
  const EstimatedSteady fine = solve_steady_to(contact, 1e-4);
  EXPECT_FALSE(fine.solution.stick_edge);
  EXPECT_GT(fine.unknowns, coarse.unknowns);
  EXPECT_LE(std::abs(coarse.solution.creepage / fine.solution.creepage - 1), coarse.error);
}

// A bound of 8193 rows begins with 4096 elements; second order would take many more than are tried.
TEST(TargetError, RefusesATargetOutOfReachAtOnce) {
  const TractionBound bound =
      rough_bound(HertzBound(1, 1), {.amplitude = 1, .hurst = 0.3, .seed = 3, .rows = 8193});
  const SteadyContact contact{{PlaneKernel({1.44, 0.28}, 20), bound},
                              PrescribedForce{-0.5 * full_sliding_force(bound)}};
  try {
    solve_steady_to(contact, 1e-4);
    FAIL() << "expected NotConverged";
  } catch (const NotConverged& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("target_error = 1e-04"));
    EXPECT_THAT(error.what(), testing::HasSubstr("the error of 4096 may be"));
    EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("iterations")));
  }
}

TEST(TargetError, RefusesTargetsOutOfRange) {
  const SteadyContact contact{{PlaneKernel(material, 10), HertzBound(5, 300)},
                              PrescribedForce{-1500}};
  EXPECT_THROW(solve_steady_to(contact, 1e-12), std::invalid_argument);
  EXPECT_THROW(solve_steady_to(contact, 0.2), std::invalid_argument);
  EXPECT_THROW(solve_steady_to({contact, PrescribedForce{-1e9}}, 0.01), std::invalid_argument);
}

TEST(TargetError, IsZeroWithoutALoad) {
  const EstimatedSteady found = solve_steady_to(
      {{PlaneKernel(material, 10), HertzBound(5, 300)}, PrescribedCreepage{0}}, 1e-6);
  EXPECT_EQ(found.solution.force, 0);
  EXPECT_LE(found.error, 1e-6);
}

}  // namespace microslip::target_error_test
