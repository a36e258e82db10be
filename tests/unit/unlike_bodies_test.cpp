// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of different material in steady rolling: closed forms of free rolling, partial slip by
// other methods, symmetry, and what CONTACT prints.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"
#include "test_name.hpp"

namespace microslip::unlike_bodies_test {

using Eigen::Index;
using Eigen::VectorXd;

const Material material{1.44, 0.28};
const HertzBound bound(1, 1);

/// \param ratio        beta/mu
/// \param force_ratio  T, over full sliding
SteadySolution rolled(double ratio, double force_ratio, Index elements,
                      const char* scheme = "calibrated") {
  return solve_steady(solved_by(
      steady_scheme(scheme),
      {.contact = {PlaneKernel(material, 20), bound, pressure_strain({material, ratio}, 1)},
       .grid = Grid({.half_width = 1, .elements = elements}),
       .load = PrescribedForce{force_ratio * full_sliding_force(bound)}}));
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

// Free rolling without slip: 2/pi, to second order and better.
TEST(UnlikeBodies, WithoutSlip) {
  for (const Index n : {50, 100, 200, 400}) {
    const SteadySolution solution = rolled(0.02, 0, n);
    EXPECT_EQ(number_of_zones(solution), 1);
    const double elements = static_cast<double>(n);
    EXPECT_NEAR(creepage(0.02, 0, n) * std::numbers::pi / 2, 1,
                0.02 / (elements * elements) + 1e-7);
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
                                         PartialSlip{-0.75, 2.69428 / 2.87667, 7e-6, 3}),
                         [](const auto& of) {
                           return test::place({{"force_ratio", of.param.force_ratio}});
                         });

// Closed forms and other methods, by the inversion: ten digits, whatever the number of nodes.
TEST(UnlikeBodies, ByInversionAreExact) {
  const double by_elements = creepage(2.87667, 0, 12801);
  EXPECT_NEAR(creepage(2.87667, 0, 11, "inversion"), by_elements, 1e-8);
  EXPECT_NEAR(creepage(0.02, 0, 11, "inversion"), 2 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(creepage(0.1, 0, 11, "inversion"), 2 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(creepage(1e5, 0, 11, "inversion"), 2 * 0.457385508786518, 1e-7);
  EXPECT_NEAR(creepage(2.87667, 0, 11, "inversion"), 2 * 0.372097, 4e-6);
  EXPECT_NEAR(creepage(2.87667, 0.75, 11, "inversion") * 2.87667, 1.04729, 3e-5);
  EXPECT_NEAR(creepage(2.87667, -0.75, 11, "inversion") * 2.87667, 2.69428, 2e-5);
}

// Under a positive force two zones at the trailing edge are 7e-4 a wide together, and five in all.
TEST(UnlikeBodies, HaveZonesThatElementsDoNotSee) {
  EXPECT_EQ(number_of_zones(rolled(2.87667, 0.75, 400)), 3);
  const SteadySolution fine = rolled(2.87667, 0.75, 20001, "inversion");
  EXPECT_EQ(number_of_zones(fine), 5);
  EXPECT_EQ(fine.scheme, SteadyScheme::inversion);
}

// Carter's problem, as the ratio goes to zero.
TEST(UnlikeBodies, ByInversionAreCartersWhereAlike) {
  const double alike = (1 - std::sqrt(1 - 0.36)) * compliance(material);
  EXPECT_NEAR(rolled(1e-9, -0.36, 101, "inversion").creepage, alike, 1e-8 * alike);
}

struct Rolled {
  double ratio, force_ratio;
};

/// Ratios from 0.03 to 300 and forces up to 0.9 of full sliding, by a low-discrepancy sequence.
std::vector<Rolled> generated_loads() {
  std::vector<Rolled> loads;
  for (int i = 1; i <= 40; ++i) {
    const double one = std::fmod(0.7548776662466927 * i, 1);
    const double two = std::fmod(0.5698402909980532 * i, 1);
    loads.push_back({0.03 * std::pow(1e4, one), 0.9 * (2 * two - 1)});
  }
  return loads;
}

// Against elements, of first order where a zone is as short as one, and of second otherwise; and
// against the equations themselves, with the tractions as line loads.
TEST(UnlikeBodies, ByInversionMeetTheEquationsOfGeneratedLoads) {
  const double unit = compliance(material);
  for (const auto& [ratio, force_ratio] : generated_loads()) {
    SCOPED_TRACE(testing::Message() << ratio << ' ' << force_ratio);
    const Index n = 2001;
    const SteadySolution found = rolled(ratio, force_ratio, n, "inversion");
    ASSERT_EQ(found.scheme, SteadyScheme::inversion);
    const double scale = (1 + ratio) * unit;
    EXPECT_NEAR(found.creepage, rolled(ratio, force_ratio, 1601).creepage, 5e-4 * scale);
    const double dx = 2.0 / static_cast<double>(n);
    EXPECT_NEAR(dx * found.traction.sum(), found.force, 1e-3);
    const VectorXd u =
        influence_operator(PlaneKernel(material, 20), constant_basis(), dx, n, {}) * found.traction;
    EXPECT_LT((u - found.displacement).lpNorm<Eigen::Infinity>(), 2e-3 * unit);
    for (Index i = 0; i < n; ++i) {
      EXPECT_LE(std::abs(found.traction[i]), found.bound[i] * (1 + 1e-4));
      EXPECT_LE(found.traction[i] * found.slip[i], 1e-6 * scale);
    }
    EXPECT_LE(found.evidence.violation(), 1e-6);
    const SteadySolution mirrored = rolled(-ratio, -force_ratio, 11, "inversion");
    EXPECT_NEAR(mirrored.creepage, -found.creepage, 1e-9 * scale);
  }
}

TEST(UnlikeBodies, ByInversionTakeACreepage) {
  SteadyProblem problem{
      .contact = {PlaneKernel(material, 20), bound, pressure_strain({material, 3}, 1)},
      .grid = Grid({.half_width = 1, .elements = 51}),
      .load = PrescribedCreepage{rolled(3, 0.4, 51, "inversion").creepage}};
  EXPECT_NEAR(solve_steady(problem).force / full_sliding_force(bound), 0.4, 1e-9);
  problem.load = PrescribedCreepage{100 * compliance(material)};
  const SteadySolution sliding = solve_steady(problem);
  EXPECT_EQ(sliding.scheme, SteadyScheme::inversion);
  EXPECT_NEAR(sliding.force, -full_sliding_force(bound), 1e-10);
  EXPECT_NEAR(sliding.slip[25] / compliance(material), 100 - 3, 1e-9);  // in the middle
}

TEST(UnlikeBodies, UnderOtherBoundsAreOfElements) {
  SteadyProblem problem{
      .contact = {PlaneKernel(material, 20), PolynomialBound(1, 1, Eigen::Vector3d(1, 0.2, 0.1)),
                  pressure_strain({material, 1}, 1)},
      .grid = Grid({.half_width = 1, .elements = 101}),
      .load = PrescribedForce{0}};
  const SteadySolution found = solve_steady(problem);
  EXPECT_EQ(found.scheme, SteadyScheme::calibrated);
  EXPECT_EQ(found.fallback, "bodies differ in material, and the bound is not Hertz's");
}

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
  EXPECT_NEAR(problem.contact.pressure_strain / pressure_strain(bodies, 0.2), 1, 1e-14);
  const SteadySolution solution = solve_steady(problem);
  EXPECT_EQ(solution.scheme, SteadyScheme::inversion);
  EXPECT_EQ(solution.fallback, "");

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
  EXPECT_EQ(refusal({"material.poisson_ratio_2="}), "missing key 'material.poisson_ratio_2'");
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
      "key 'material.poisson_ratio_2' has no role here: it is for problem steady or transient with";
  const std::vector<std::string> transient = {"problem=transient", "start.type=rest",
                                              "step.ratio=1", "motion.distance=1"};
  EXPECT_EQ(refusal(transient), "");
  std::vector<std::string> of_strip = transient;
  of_strip.insert(of_strip.end(), {"kernel.type=strip", "kernel.length=", "kernel.width=5"});
  EXPECT_EQ(refusal(of_strip),
            "kernel.type = 'strip': expected plane for bodies of different material");
  EXPECT_TRUE(refusal({"target_error=1e-3", "grid.elements="}).starts_with(no_role));
}

}  // namespace microslip::unlike_bodies_test
