// SPDX-License-Identifier: GPL-3.0-or-later
// Transients of bodies of different material: against steady rolling by inversion, a dense scheme
// that shares no code, symmetry, energy, and derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::unlike_transients_test {

using Eigen::Index;
using Eigen::VectorXd;

const Material material{1, 0};  // of the compliance 2
constexpr double far = 20;      // L0
constexpr double unit = 2;      // compliance times peak
const HertzBound bound(1, 1);

Contact contact_of(double ratio) {
  return {PlaneKernel(material, far), bound, pressure_strain({material, ratio}, 1)};
}

TransientProblem problem_of(double ratio, Index elements, const AdvectionScheme& scheme) {
  return {.contact = contact_of(ratio),
          .grid = Grid({.half_width = 1, .elements = elements}),
          .basis = constant_basis(),
          .scheme = scheme};
}

SteadySolution steady(double ratio, const Load& load) {
  return solve_steady({.contact = contact_of(ratio),
                       .grid = Grid({.half_width = 1, .elements = 101}),
                       .load = load});
}

Load force_of(double ratio) { return PrescribedForce{ratio * full_sliding_force(bound)}; }

TransientRolling rolled(double ratio, Index elements, const Load& load, double distance,
                        double step_ratio, const AdvectionScheme& scheme = Remembered{}) {
  TransientRolling rolling(problem_of(ratio, elements, scheme));
  const double length = step_ratio * 2 / static_cast<double>(elements);
  while (rolling.state().distance < distance) rolling.step(length, load);
  return rolling;
}

struct Case {
  double ratio, force_ratio;
};

const std::vector<Case> cases{{0.5, 0},        {1, 0.4},        {2.87667, 0}, {2.87667, -0.75},
                              {2.87667, 0.75}, {-2.87667, 0.3}, {10, 0.2},    {30, -0.5}};

// After four contact widths the creepage under a force is that of steady rolling.
TEST(UnlikeTransients, ReachSteadyRolling) {
  for (const auto& [ratio, force_ratio] : cases) {
    const Load load = force_of(force_ratio);
    const double exact = steady(ratio, load).creepage;
    for (const double step_ratio : {0.3, 1.0, 1.7}) {
      SCOPED_TRACE(testing::Message() << ratio << ' ' << force_ratio << ' ' << step_ratio);
      const TransientRolling rolling = rolled(ratio, 100, load, 8, step_ratio);
      const double error = rolling.state().creepage - exact;
      EXPECT_NEAR(error, 0, 1e-3 * unit * (1 + std::abs(ratio)));
    }
    const TransientRolling direct = rolled(ratio, 100, load, 8, 1, Direct{});
    EXPECT_NEAR(direct.state().creepage, exact, 3e-3 * unit * (1 + std::abs(ratio)));
  }
}

/// The displacement of an element of the length dx and a unit traction, at the distance z.
double displaced(double z, double dx) {
  const auto integral = [](double x) { return x == 0 ? 0 : x * std::log(std::abs(x) / far) - x; };
  return -unit / std::numbers::pi * (integral(z + dx / 2) - integral(z - dx / 2));
}

/// Force at the end of so many steps of one element under a creepage, from rest: nodes in the
/// middle of elements that fill the contact, material that moves on by one node, and projected
/// Gauss-Seidel sweeps.
double dense_force(double ratio, double creepage, double distance, int n) {
  const double dx = 2.0 / n;
  const auto pressed = [&](double x) {
    const double in = std::clamp(x, -1.0, 1.0);
    return unit * ratio * (in * std::sqrt(1 - in * in) + std::asin(in)) / 2;
  };
  std::vector<double> p(static_cast<std::size_t>(n), 0.0), kernel, before = p;
  for (int i = 0; i <= n; ++i) kernel.push_back(displaced(i * dx, dx));
  const auto at = [&](int i, int j) { return kernel[static_cast<std::size_t>(std::abs(i - j))]; };
  const int steps = static_cast<int>(std::lround(distance / dx));
  for (int step = 0; step < steps; ++step) {
    before = p;
    std::vector<double> fixed;
    for (int i = 0; i < n; ++i) {
      const double x = -1 + (i + 0.5) * dx;
      double slip = creepage * dx + pressed(x) - pressed(x + dx);
      for (int j = 0; j < n; ++j) slip -= at(i + 1, j) * before[static_cast<std::size_t>(j)];
      fixed.push_back(slip);
    }
    for (int sweep = 0; sweep < 400; ++sweep) {
      for (int i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        double slip = fixed[k];
        for (int j = 0; j < n; ++j) slip += at(i, j) * p[static_cast<std::size_t>(j)];
        const double x = -1 + (i + 0.5) * dx;
        const double g = std::sqrt(1 - x * x);
        p[k] = std::clamp(p[k] - slip / at(0, 0), -g, g);
      }
    }
  }
  double force = 0;
  for (const double traction : p) force += dx * traction;
  return force;
}

// The dense scheme is of first order: its error is about as large as the change by twice the
// elements.
TEST(UnlikeTransients, AgreeWithADenseScheme) {
  struct Run {
    double ratio, creepage, distance;
  };
  for (const auto& [ratio, creepage, distance] :
       {Run{0.6, 0.3, 1}, Run{2, 2.2, 0.5}, Run{2, 2.2, 2}, Run{-3, 0.5, 1}, Run{6, 9, 2}}) {
    SCOPED_TRACE(testing::Message() << ratio << ' ' << creepage << ' ' << distance);
    const double coarse = dense_force(ratio, creepage, distance, 48);
    const double fine = dense_force(ratio, creepage, distance, 96);
    for (const double c : {1.0, 0.5}) {
      const TransientRolling rolling =
          rolled(ratio, 96, PrescribedCreepage{creepage}, distance - 1e-9, c);
      EXPECT_NEAR(rolling.state().force, fine, std::abs(fine - coarse) + 1e-3);
    }
  }
}

TEST(UnlikeTransients, AreSymmetric) {
  for (const AdvectionScheme& scheme : {AdvectionScheme(Remembered{}), AdvectionScheme(Direct{})}) {
    const TransientRolling one = rolled(2, 50, force_of(0.3), 3, 0.7, scheme);
    const TransientRolling other = rolled(-2, 50, force_of(-0.3), 3, 0.7, scheme);
    EXPECT_NEAR(one.state().creepage, -other.state().creepage, 1e-10);
    EXPECT_LT((one.state().traction + other.state().traction).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

// The dissipation becomes the dissipation by slip in steady rolling, although without a force the
// force does no work.
TEST(UnlikeTransients, DissipateTheWorkOfThePressure) {
  for (const double ratio : {2.87667, 10.0, 30.0}) {
    const SteadySolution expected = steady(ratio, force_of(0));
    const TransientRolling rolling = rolled(ratio, 200, force_of(0), 8, 1);
    EXPECT_NEAR(rolling.state().dissipation / expected.dissipation, 1, 3e-3);
  }
}

TEST(UnlikeTransients, HaveDerivatives) {
  TransientRolling rolling = rolled(2, 60, force_of(0.3), 2, 0.6);
  const double length = 0.013, creepage = rolling.state().creepage, by = 1e-6;
  StepJacobian jacobian;
  rolling.attempt(length, PrescribedCreepage{creepage}, jacobian);
  const auto after = [&](double dq, double w) {
    return rolling.attempt(dq, PrescribedCreepage{w});
  };
  const TransientState more = after(length, creepage + by), less = after(length, creepage - by);
  const TransientState longer = after(length + by, creepage),
                       shorter = after(length - by, creepage);
  EXPECT_NEAR(jacobian.by_load.force, (more.force - less.force) / (2 * by), 1e-5);
  EXPECT_NEAR(jacobian.by_load.dissipation, (more.dissipation - less.dissipation) / (2 * by), 1e-4);
  EXPECT_NEAR(jacobian.by_length.force, (longer.force - shorter.force) / (2 * by), 1e-4);
  EXPECT_NEAR(jacobian.by_length.dissipation, (longer.dissipation - shorter.dissipation) / (2 * by),
              1e-3);
}

TEST(UnlikeTransients, GoOnFromTheirState) {
  TransientRolling rolling = rolled(2, 50, force_of(0.3), 1, 0.6);
  TransientRolling other(problem_of(2, 50, Remembered{}), SavedState{rolling.save()});
  rolling.step(0.05, force_of(0.3));
  other.step(0.05, force_of(0.3));
  EXPECT_EQ(rolling.state().creepage, other.state().creepage);
  EXPECT_THROW(TransientRolling(problem_of(1, 50, Remembered{}), SavedState{rolling.save()}),
               std::invalid_argument);
  EXPECT_THROW(TransientRolling(problem_of(0, 50, Remembered{}), SavedState{rolling.save()}),
               std::invalid_argument);
}

// Shifts keep what the pressure has displaced.
TEST(UnlikeTransients, ShiftAndRollOn) {
  TransientRolling rolling = rolled(2, 100, force_of(0), 6, 1);
  const double creepage = rolling.state().creepage;
  rolling.shift(PrescribedShift{1e-9});
  rolling.shift(PrescribedForce{0});
  for (int i = 0; i < 400; ++i) rolling.step(0.02, force_of(0));
  EXPECT_NEAR(rolling.state().creepage, creepage, 1e-4 * creepage);
}

TEST(UnlikeTransients, AreRefusedWhereThereIsNoModel) {
  TransientProblem strip = problem_of(1, 50, Remembered{});
  strip.contact.kernel = StripKernel(material, 2);
  EXPECT_THROW(TransientRolling{strip}, std::invalid_argument);
  TransientRolling rolling(problem_of(1, 50, Remembered{}));
  EXPECT_THROW(rolling.set_contact({.half_width = 1.1, .bound = 1}), std::invalid_argument);
  EXPECT_NO_THROW(rolling.set_contact({}));
}

const std::string scene = R"(
problem transient
material { shear_modulus 1
  poisson_ratio 0
  dundurs_beta 0.2 }
contact { half_width 1
  peak_traction 1
  friction 0.1 }
kernel { type plane
  length 20 }
grid { elements 50 }
load { force 0.4 }
start { type rest }
step { ratio 1 }
motion { distance 3 }
)";

double last_creepage(const std::vector<std::string>& settings) {
  Scene from = scene_of(scene);
  for (const std::string& setting : settings) from.set(setting);
  const auto read = std::get<TransientScene>(read_model(from));
  from.reject_unread();
  TransientRolling rolling(read.problem, read.start);
  rolling.roll(read.distance, read.step_lengths(), read.loads, [](const TransientState&) {});
  return rolling.state().creepage;
}

TEST(UnlikeTransients, AreReadFromScenes) {
  const TransientRolling expected = rolled(2, 50, PrescribedForce{0.4}, 3 - 1e-9, 1);
  EXPECT_NEAR(last_creepage({}), expected.state().creepage, 1e-9);
  // The creepage of like bodies follows to the bit if beta is 0, or across the rolling.
  const double alike = last_creepage({"material.dundurs_beta=", "contact.friction="});
  EXPECT_EQ(last_creepage({"material.dundurs_beta=0", "contact.friction="}), alike);
  EXPECT_EQ(last_creepage({"material.dundurs_beta=0.2", "contact.friction=", "direction=lateral"}),
            last_creepage({"material.dundurs_beta=", "contact.friction=", "direction=lateral"}));
}

TEST(UnlikeTransients, WantFriction) {
  EXPECT_EQ(message_in_keys([] { last_creepage({"contact.friction="}); }),
            "missing key 'contact.friction'");
}

}  // namespace microslip::unlike_transients_test
