// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz's line contact, by itself and as scenes describe it.
#include "microslip/reference/line_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "scene_text.hpp"

namespace microslip::line_contact_test {

using std::numbers::pi;

/// Sum of a pressure p0 sqrt(1 - t^2) over x - t, on Gauss and Chebyshev's points of the second
/// kind and between them, where this rule is exact.
double hilbert(double x, int n, double p0) {
  double sum = 0;
  for (int j = 1; j <= n; ++j) {
    const double angle = j * pi / (n + 1);
    const double sine = std::sin(angle);
    sum += pi / (n + 1) * sine * sine / (x - std::cos(angle));
  }
  return p0 * sum;
}

// Steel on steel: a wheel of 460 mm on a plane, 60 kN per 10 mm. E* = 115.385 GPa.
TEST(LineContact, IsThatOfTextbooks) {
  const LineContact contact({210000 / 2.6, 0.3}, 6000, 1.0 / 460);
  EXPECT_NEAR(contact.half_width(), 5.5187, 1e-4);
  EXPECT_NEAR(contact.peak_pressure(), 692.14, 1e-2);
  EXPECT_NEAR(contact.peak_pressure(), std::sqrt(6000 * 210000 / (2 * 0.91) / (pi * 460)), 1e-10);
}

// The pressure carries the load and closes the gap x^2/(2 R'): its slope is that of the surfaces,
// 2/(pi E*) times the sum of the pressure over the distance.
TEST(LineContact, ClosesTheGap) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 100; ++i) {
    const auto size = [&](double least, double most) {
      return least * std::pow(most / least, uniform(generator));
    };
    const double youngs_modulus = size(1, 1e6), nu = 0.5 * uniform(generator);
    const double load = size(1e-3, 1e6), curvature = size(1e-6, 1e3);
    const LineContact contact({youngs_modulus / (2 * (1 + nu)), nu}, load, curvature);
    const double a = contact.half_width();
    EXPECT_NEAR(pi / 2 * a * contact.peak_pressure() / load, 1, 1e-14);
    const double joint = youngs_modulus / (2 * (1 - nu * nu));
    for (const int k : {1, 4, 9}) {
      const double x = std::cos((2 * k - 1) * pi / (2 * (20 + 1)));
      const double slope = 2 / (pi * joint) * hilbert(x, 20, contact.peak_pressure());
      EXPECT_NEAR(slope / (curvature * a * x), 1, 1e-12);
    }
  }
}

struct Derived {
  double half_width, peak, force;
};

/// Returns the derived quantities of a scene under 0.36 of full sliding.
Derived derived(const std::string& material, const std::string& contact) {
  Scene scene = scene_of("problem steady\nmaterial { " + material + " }\ncontact { " + contact +
                         " }\nkernel { type plane\n length 1 m }\ngrid { elements 20 }\n"
                         "load { force_ratio 0.36 }");
  const auto problem = std::get<SteadyProblem>(read_model(scene));
  scene.reject_unread();
  const auto& bound = std::get<HertzBound>(problem.contact.bound);
  EXPECT_EQ(problem.grid.half_width(), bound.half_width());
  return {bound.half_width(), bound.peak(), std::get<PrescribedForce>(problem.load).value};
}

void expect_equal(const Derived& a, const Derived& b) {
  EXPECT_NEAR(a.half_width / b.half_width, 1, 1e-14);
  EXPECT_NEAR(a.peak / b.peak, 1, 1e-14);
  EXPECT_NEAR(a.force / b.force, 1, 1e-14);
}

TEST(LineContact, OfAScene) {
  const Derived steel = derived("youngs_modulus 210 GPa\n poisson_ratio 0.3",
                                "normal_load 6 MN/m\n radius_1 460 mm\n friction 0.3");
  EXPECT_NEAR(steel.half_width, 5.5187, 1e-4);
  EXPECT_NEAR(steel.peak, 0.3 * 692.14, 1e-2);
  EXPECT_NEAR(steel.force, 0.36 * 0.3 * 6000, 1e-9);
}

// The same contact in other units, by G instead of E, by two radii instead of one, and with both in
// the other order.
TEST(LineContact, OfASceneDoesNotDependOnHowItIsWritten) {
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 50; ++i) {
    const double nu = 0.5 * uniform(generator), mu = 0.01 + uniform(generator);
    const double load = 1 + 1000 * uniform(generator), radius = 100 + 900 * uniform(generator);
    const double other = radius * (1.5 + uniform(generator));
    const std::string ratio = "\n poisson_ratio " + format_full(nu);
    const std::string friction = "\n friction " + format_full(mu);
    const std::string material = "youngs_modulus " + format_full(2e5) + ratio;
    const auto loaded = [&](double value, const std::string& unit) {
      return "normal_load " + format_full(value) + unit + friction;
    };
    const auto radii = [](double one, double two) {
      return "\n radius_1 " + format_full(one) + "\n radius_2 " + format_full(two);
    };
    for (const double sign : {1.0, -1.0}) {
      const std::string contact = loaded(load, "") + radii(radius, sign * other);
      const Derived plain = derived(material, contact);
      expect_equal(derived("shear_modulus " + format_full(2e5 / (2 * (1 + nu))) + ratio, contact),
                   plain);
      expect_equal(derived("youngs_modulus 200 GPa\n poisson_ratio " + format_full(nu), contact),
                   plain);
      expect_equal(derived(material, loaded(load, " kN/m") + radii(radius, sign * other)), plain);
      expect_equal(derived(material, loaded(load / 1000, " kN/mm") + "\n radius_1 " +
                                         format_full(radius / 1000) + " m\n radius_2 " +
                                         format_full(sign * other / 10) + " cm"),
                   plain);
      const double relative = radius * other / (other + sign * radius);
      expect_equal(derived(material, loaded(load, "") + "\n radius_1 " + format_full(relative)),
                   plain);
      if (sign > 0) {
        expect_equal(derived(material, loaded(load, "") + radii(other, radius)), plain);
      }
      // Twice as long, and three times as stiff: the load has the dimension of their product.
      const Derived larger = derived("youngs_modulus " + format_full(6e5) + ratio,
                                     loaded(6 * load, "") + radii(2 * radius, 2 * sign * other));
      expect_equal(larger, {2 * plain.half_width, 3 * plain.peak, 6 * plain.force});
    }
  }
}

// A half-width of 1 mm, and a smaller radius that is ten times as large or just less.
TEST(LineContact, IsWarnedOfWhereItIsNotSmall) {
  const auto warnings = [](double other) {
    const double radius = 1000, relative = 1 / (1 / radius + 1 / other);
    const double stiffness = 1e5 / (2 * (1 - 0.09));
    Scene scene = scene_of(
        "problem steady\nmaterial { youngs_modulus 1e5\n poisson_ratio 0.3 }\n"
        "contact { friction 0.3\n radius_1 1000\n radius_2 " +
        format_full(other) + "\n normal_load " + format_full(pi * stiffness / (4 * relative)) +
        " }\nkernel { type plane\n length 1 m }\ngrid { elements 20 }\n"
        "load { force_ratio 0.5 }");
    read_model(scene);
    return scene.warnings();
  };
  EXPECT_TRUE(warnings(10.001).empty());
  ASSERT_EQ(warnings(9.999).size(), 1u);
  EXPECT_NE(warnings(9.999)[0].line.find("is more than a tenth of the smaller radius"),
            std::string::npos);
}

// Carter's stick zone by steady rolling in plane strain; the force is that of a positive creepage.
TEST(LoadRatios, GiveTheZoneAndTheForce) {
  for (const double ratio : {0.05, 0.31, 0.6, 0.97}) {
    Scene scene = scene_of(
        "problem steady\nmaterial { shear_modulus 82 GPa\n poisson_ratio 0.28 }\n"
        "contact { half_width 5\n peak_traction 300 }\nkernel { type plane\n length 1 m }\n"
        "grid { elements 20 }\nload { stick_ratio " +
        format_full(ratio) + " }");
    const auto problem = std::get<SteadyProblem>(read_model(scene));
    const SteadySolution solution = solve_steady(problem);
    EXPECT_NEAR(*solution.stick_edge, 5 * (1 - 2 * ratio), 1e-8);
    EXPECT_GT(solution.creepage, 0);
    EXPECT_LT(solution.force, 0);
    Scene same = scene;
    same.set("load.stick_ratio=");
    same.set("load.force_ratio=" +
             format_full(solution.force / full_sliding_force(problem.contact.bound)));
    const auto by_force = std::get<SteadyProblem>(read_model(same));
    EXPECT_NEAR(std::get<PrescribedForce>(by_force.load).value / solution.force, 1, 1e-14);
  }
}

}  // namespace microslip::line_contact_test
