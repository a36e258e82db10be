// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of different material in steady rolling: closed forms of free rolling, partial slip by
// other methods, symmetry, and what CONTACT prints.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip {
namespace {

using Eigen::Index;

const Material material{1.44, 0.28};
const HertzBound bound(1, 1);

/// \param ratio        beta/mu
/// \param force_ratio  T, over full sliding
SteadySolution rolled(double ratio, double force_ratio, Index elements,
                      const char* scheme = "calibrated") {
  return solve_steady(solved_by(steady_scheme(scheme),
                                {.kernel = PlaneKernel(material, 20),
                                 .bound = bound,
                                 .grid = Grid({.half_width = 1, .elements = elements}),
                                 .load = PrescribedForce{force_ratio * full_sliding_force(bound)},
                                 .pressure_strain = pressure_strain({material, ratio}, 1)}));
}

/// The creepage over the strain that the pressure makes in the middle, c = beta a/R.
double creepage(double ratio, double force_ratio, Index elements,
                const char* scheme = "calibrated") {
  return rolled(ratio, force_ratio, elements, scheme).creepage / (ratio * compliance(material));
}

int number_of_zones(const SteadySolution& solution) {
  int zones = 1;
  for (std::size_t i = 1; i < solution.zones.size(); ++i) {
    zones += solution.zones[i] != solution.zones[i - 1] ? 1 : 0;
  }
  return zones;
}

TEST(UnlikeBodies, OfAluminiumAndSteel) {
  const Bodies bodies = combined({82000, 0.28}, {23000, 0.31});
  EXPECT_NEAR(bodies.combined.shear_modulus, 35923.8095238, 1e-6);
  EXPECT_NEAR(bodies.combined.poisson_ratio, 0.303428571429, 1e-11);
  EXPECT_NEAR(bodies.dundurs_beta / 0.05, 2.87667, 1e-5);
  EXPECT_EQ(combined({23000, 0.31}, {82000, 0.28}).dundurs_beta, -bodies.dundurs_beta);
  const Bodies alike = combined(material, material);
  EXPECT_NEAR(alike.combined.shear_modulus / material.shear_modulus, 1, 1e-15);
  EXPECT_NEAR(alike.combined.poisson_ratio / material.poisson_ratio, 1, 1e-15);
  EXPECT_EQ(alike.dundurs_beta, 0);
  EXPECT_NEAR(combined({1, 0}, {1e40, 0.5}).dundurs_beta, -0.5, 1e-15);
}

// Free rolling without slip: 2/pi. Elements do not resolve a trailing edge that sticks.
TEST(UnlikeBodies, WithoutSlipIsOfFirstOrder) {
  double before = 0;
  for (const Index n : {50, 100, 200, 400}) {
    const SteadySolution solution = rolled(0.02, 0, n);
    EXPECT_EQ(number_of_zones(solution), 1);
    const double error = creepage(0.02, 0, n) * std::numbers::pi / 2 - 1;
    EXPECT_LT(std::abs(error), 0.06 / static_cast<double>(n));
    EXPECT_NEAR(before == 0 ? 2 : before / error, 2, 0.1);
    before = error;
  }
}

// Bentall and Johnson (1967): 0.457385508786518 kappa a/R for a coefficient of friction near 0.
TEST(UnlikeBodies, WithLittleFriction) {
  for (const Index n : {100, 200, 400, 800}) {
    EXPECT_NEAR(creepage(1e4, 0, n) / (2 * 0.457385508786518), 1, 2e-3);
  }
}

struct PartialSlip {
  double force_ratio;
  double creepage;  ///< over beta a/R, by a Gauss-Chebyshev method; B = 2.87667
  double error;     ///< of that, in its last digit
  int zones;
};

class PartialSlips : public testing::TestWithParam<PartialSlip> {};

TEST_P(PartialSlips, AgreeWithOtherMethods) {
  const auto [force_ratio, expected, error, zones] = GetParam();
  for (const Index n : {200, 400, 800}) {
    EXPECT_NEAR(creepage(2.87667, force_ratio, n), expected, error + 5e-6);
    EXPECT_EQ(number_of_zones(rolled(2.87667, force_ratio, n)), zones);
  }
}

INSTANTIATE_TEST_SUITE_P(UnlikeBodies, PartialSlips,
                         testing::Values(PartialSlip{0, 2 * 0.372097, 4e-6, 5},
                                         PartialSlip{0.75, 1.04729 / 2.87667, 2e-5, 3},
                                         PartialSlip{-0.75, 2.69428 / 2.87667, 7e-6, 3}));

// CONTACT prints 4.294e-4 with N = 200, a = 0.1 mm and R = 25 mm, and 4.2816e-4 is exact.
TEST(UnlikeBodies, ByTheSchemeOfContactAreOfFirstOrder) {
  const double beta = 2.87667 * 0.05;
  const double printed = creepage(2.87667, 0, 200, "standard") * beta * 0.1 / 25;
  EXPECT_NEAR(printed, 4.294e-4, 1e-7);
  const auto error = [](Index n) { return creepage(2.87667, 0, n, "standard") - 2 * 0.372097; };
  EXPECT_NEAR(error(200) / error(400), 2, 0.1);
  EXPECT_NEAR(error(400) / error(800), 2, 0.1);
}

TEST(UnlikeBodies, AreSymmetric) {
  for (const double ratio : {0.3, 2.0, 30.0}) {
    for (const double force_ratio : {0.0, 0.3, -0.8}) {
      const SteadySolution one = rolled(ratio, force_ratio, 101);
      const SteadySolution other = rolled(-ratio, -force_ratio, 101);
      EXPECT_NEAR(one.creepage / other.creepage, -1, 1e-9);
      EXPECT_LT((one.traction + other.traction).lpNorm<Eigen::Infinity>(), 1e-9);
      EXPECT_GE(one.dissipation, 0);
      EXPECT_LE(one.evidence.violation(), 1e-9);
      EXPECT_LT((one.traction.cwiseAbs() - one.bound).maxCoeff(), 1e-12);
    }
  }
}

// A little of it changes the answer of like bodies in proportion.
TEST(UnlikeBodies, AreNearlyAlikeForASmallDifference) {
  const double alike = rolled(0, -0.5, 100).creepage;
  const double one = rolled(1e-4, -0.5, 100).creepage - alike;
  const double two = rolled(2e-4, -0.5, 100).creepage - alike;
  EXPECT_NEAR(two / one, 2, 1e-3);
  EXPECT_GT(one, 0);
}

const std::string scene = R"(
problem steady
material { youngs_modulus 200 GPa
  poisson_ratio 0.3
  youngs_modulus_2 70 GPa
  poisson_ratio_2 0.33 }
contact { normal_load 1 kN/mm
  radius_1 50 mm
  friction 0.2 }
kernel { type plane
  length 10 mm }
grid { elements 100 }
load { force_ratio -0.3 }
)";

TEST(UnlikeBodies, AreReadFromScenes) {
  Scene from = scene_of(scene);
  const SteadyProblem problem = std::get<SteadyProblem>(read_model(from));
  from.reject_unread();
  const Bodies bodies = combined({200e3 / 2.6, 0.3}, {70e3 / (2 * 1.33), 0.33});
  EXPECT_NEAR(problem.pressure_strain / pressure_strain(bodies, 0.2), 1, 1e-14);
  const SteadySolution solution = solve_steady(problem);
  EXPECT_EQ(solution.scheme, SteadyScheme::calibrated);
  EXPECT_EQ(solution.fallback, "bodies differ in material");

  Scene by_beta = scene_of(scene);
  for (const char* setting :
       {"material.youngs_modulus=", "material.youngs_modulus_2=", "material.poisson_ratio_2="}) {
    by_beta.set(setting);
  }
  by_beta.set("material.shear_modulus=" + std::to_string(bodies.combined.shear_modulus));
  by_beta.set("material.poisson_ratio=" + std::to_string(bodies.combined.poisson_ratio));
  by_beta.set("material.dundurs_beta=" + std::to_string(bodies.dundurs_beta));
  const SteadySolution same = solve_steady(read_steady(by_beta));
  EXPECT_NEAR(same.creepage / solution.creepage, 1, 1e-4);
}

TEST(UnlikeBodies, AreRefusedWhereThereIsNoModel) {
  const auto refusal = [](const std::vector<std::string>& settings) {
    return message_in_keys([&] {
      Scene from = scene_of(scene);
      for (const std::string& setting : settings) from.set(setting);
      read_model(from);
      from.reject_unread();
    });
  };
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({"method=chebyshev", "grid.elements=10"}),
            "method = 'chebyshev': expected collocation for bodies of different material");
  EXPECT_EQ(refusal({"leading_edge=known_edge"}),
            "leading_edge = 'known_edge': expected inversion, calibrated, standard or trimmed for "
            "bodies of different material");
  EXPECT_EQ(refusal({"kernel.type=strip", "kernel.length=", "kernel.width=5"}),
            "kernel.type = 'strip': expected plane for bodies of different material");
  EXPECT_EQ(refusal({"material.poisson_ratio_2="}),
            "missing key 'material.poisson_ratio_2' (did "
            "you mean 'material.poisson_ratio'?)");
  EXPECT_EQ(refusal({"material.youngs_modulus_2="}),
            "missing key 'material.shear_modulus_2' or 'material.youngs_modulus_2'");
  EXPECT_EQ(refusal({"material.poisson_ratio_2=0.6"}),
            "material.poisson_ratio_2 = 0.6: expected a number in [0, 0.5]");
  EXPECT_EQ(refusal({"material.dundurs_beta=0.1"}),
            "expected only one of 'material.dundurs_beta' and 'material.youngs_modulus_2'");
  EXPECT_EQ(refusal({"material.youngs_modulus_2=", "material.poisson_ratio_2=",
                     "material.dundurs_beta=0.51"}),
            "material.dundurs_beta = 0.51: expected a number in [-0.5, 0.5]");
  const std::string no_role =
      "key 'material.poisson_ratio_2' has no role here: it is for problem steady with";
  EXPECT_TRUE(refusal({"problem=transient", "start.type=rest", "step.ratio=1", "motion.distance=1"})
                  .starts_with(no_role));
  EXPECT_TRUE(refusal({"target_error=1e-3", "grid.elements="}).starts_with(no_role));
}

}  // namespace
}  // namespace microslip
