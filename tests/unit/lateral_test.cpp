// SPDX-License-Identifier: GPL-3.0-or-later
// Creepage across the rolling: the kernel against Cerruti's integral, Carter's solution with its
// own stiffness, and scenes.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "good_scene.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::lateral_test {

using std::numbers::pi;

// A point load Q across: u_y = Q/(2 pi G) [(1 - nu)/r + nu y^2/r^3] on each body, y across.
TEST(Lateral, KernelOfAStripIsCerrutisIntegral) {
  for (const double nu : {0.0, 0.28, 0.5}) {
    const double shear = 3, h = 0.7;
    const StripKernel kernel(lateral({shear, nu}), 2 * h);
    for (const double z : {0.03, 0.5, 4.0, 60.0}) {
      const auto load = [&](double y) {
        const double r = std::hypot(z, y);
        return ((1 - nu) / r + nu * y * y / (r * r * r)) / (pi * shear);
      };
      const double expected =
          2 * boost::math::quadrature::gauss_kronrod<double, 61>::integrate(load, 0, h, 15, 1e-12);
      EXPECT_NEAR(kernel.displacement(z) / expected, 1, 1e-11) << nu << ' ' << z;
    }
  }
}

TEST(Lateral, KernelFallsAndIsConvex) {
  const StripKernel kernel(lateral({1, 0.5}), 2);
  double before = 1e9, decay_before = 1e18;
  for (double z = 1e-6; z < 1e4; z *= 1.3) {
    EXPECT_LT(kernel.displacement(z), before);
    EXPECT_LT(kernel.decay(z), decay_before);
    EXPECT_GT(kernel.decay(z), 0);
    before = kernel.displacement(z);
    decay_before = kernel.decay(z);
  }
}

TEST(Lateral, PlaneStrainHasTheStiffnessOfAntiplaneShear) {
  const Material material{1.7, 0.3};
  const PlaneKernel kernel(lateral(material), 10);
  EXPECT_NEAR(kernel.log_factor() * pi * material.shear_modulus / 2, 1, 1e-15);
  EXPECT_NEAR(kernel.displacement(2) / (2 / (pi * 1.7) * std::log(5)), 1, 1e-15);
}

const std::string steady = good_contact + R"(
problem steady
load { force -0.9 }
)";

double creepage_of(const std::vector<std::string>& settings) {
  Scene scene = scene_of(steady);
  for (const std::string& setting : settings) scene.set(setting);
  const SteadyProblem problem = std::get<SteadyProblem>(read_model(scene));
  scene.reject_unread();
  return solve_steady(problem).creepage;
}

// Carter's creepage is in proportion to 2 (1 - nu)/G along and 2/G across.
TEST(Lateral, CarterIsSofterByOneLessNu) {
  const std::vector<std::string> plane{"kernel.type=plane", "kernel.width=", "kernel.length=10"};
  std::vector<std::string> across = plane;
  across.emplace_back("direction=lateral");
  EXPECT_NEAR(creepage_of(plane) / creepage_of(across), 1 - 0.28, 1e-12);
  const double full = pi / 2;
  EXPECT_NEAR(creepage_of(across), 2 * (1 - std::sqrt(1 - 0.9 / full)), 1e-12);
}

// Wide strips tend to plane strain, with the limit of L0 that the lateral kernel has.
TEST(Lateral, StripsDifferByMoreThanTheFactor) {
  const double along = creepage_of({"kernel.width=2"});
  const double across = creepage_of({"kernel.width=2", "direction=lateral"});
  EXPECT_GT(across / along, 1.05);
  EXPECT_LT(across / along, 1 / (1 - 0.28));
  EXPECT_NEAR(creepage_of({"kernel.width=2", "direction=lateral", "leading_edge=calibrated",
                           "grid.elements=801"}) /
                  across,
              1, 1e-4);
  EXPECT_EQ(creepage_of({"direction=longitudinal"}), creepage_of({}));
}

// All sticks: dF/dw in the linear theory, with the stiffness across.
TEST(Lateral, FrequencyResponseHasItsOwnStiffness) {
  const Material material{1.7, 0.3};
  const FrequencyResponse along(PlaneKernel(material, 10), -1, 1, 0.5);
  const FrequencyResponse across(PlaneKernel(lateral(material), 10), -1, 1, 0.5);
  for (const double length : {0.5, 3.0, 40.0}) {
    EXPECT_NEAR(std::abs(across.slope(length) / along.slope(length) - (1 - 0.3)), 0, 1e-12);
  }
}

TEST(Lateral, TransientsTakeIt) {
  const auto force_of = [](const char* direction) {
    Scene scene = scene_of(good_contact +
                           "problem transient\nload { creepage 0.01 }\nstart { type rest }\n"
                           "step { ratio 1 }\nmotion { distance 1 }\n");
    scene.set(std::string("direction=") + direction);
    scene.set("kernel.type=plane");
    scene.set("kernel.width=");
    scene.set("kernel.length=10");
    const TransientScene read = std::get<TransientScene>(read_model(scene));
    TransientRolling rolling(read.problem, read.start);
    rolling.roll(read.distance, read.step_lengths(), read.loads, [](const TransientState&) {});
    return rolling.state().force;
  };
  EXPECT_NEAR(force_of("lateral") / force_of("longitudinal"), 1 - 0.28, 1e-3);  // nearly all sticks
}

TEST(Lateral, IsRefusedForACylinderAndForOtherWords) {
  EXPECT_EQ(message([] { creepage_of({"direction=across"}); }),
            "direction = 'across': expected longitudinal or lateral");
  EXPECT_THROW(StripKernel({1, -1.1}, 1), std::invalid_argument);
  EXPECT_THROW(validate(Material{1, -0.1}), std::invalid_argument);
}

}  // namespace microslip::lateral_test
