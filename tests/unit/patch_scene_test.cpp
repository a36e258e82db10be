// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipses as scenes give them: by semi-axes, by load and radii, with three components of a load.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/reference/point_contact.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/scene/explanation.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::patch_scene_test {

using std::numbers::pi;

const std::string ellipse = R"(
problem steady
material { shear_modulus 80 GPa
  poisson_ratio 0.3 }
contact { half_width 6 mm
  lateral_half_width 4 mm
  peak_traction 300 MPa }
load { lateral_creepage 0.001
  spin 0.2 1/m }
)";

SteadyPatch patch_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  Scene scene = scene_of(text);
  for (const std::string& setting : settings) scene.set(setting);
  const Model model = read_model(scene);
  scene.reject_unread();
  return std::get<SteadyPatch>(model);
}

TEST(PatchScene, HasItsSemiAxesAndMotions) {
  const SteadyPatch patch = patch_of(ellipse);
  EXPECT_EQ(patch.bound.half_width(), 6);
  EXPECT_EQ(patch.bound.lateral_half_width(), 4);
  EXPECT_EQ(patch.bound.peak(), 300);
  EXPECT_EQ(patch.load, (PatchLoad{{{false, 0}, {false, 0.001}, {false, 2e-4}}}));
  EXPECT_EQ(patch.material.shear_modulus, 8e4);
}

TEST(PatchScene, HasThePeakOfItsLoad) {
  const SteadyPatch patch = patch_of(
      ellipse, {"contact.peak_traction=", "contact.normal_load=80 kN", "contact.friction=0.3"});
  EXPECT_NEAR(patch.bound.total(), 0.3 * 8e4, 1e-9);
}

TEST(PatchScene, HasHertzsEllipseByRadii) {
  const SteadyPatch patch = patch_of(
      ellipse, {"contact.half_width=", "contact.lateral_half_width=", "contact.peak_traction=",
                "contact.normal_load=80 kN", "contact.friction=0.3", "contact.radius_1=46 cm",
                "contact.lateral_radius_1=-600", "contact.lateral_radius_2=300"});
  const PointContact contact({8e4, 0.3}, 8e4, 1 / 460.0, 1 / 300.0 - 1 / 600.0);
  EXPECT_NEAR(patch.bound.half_width(), contact.half_width(), 1e-12);
  EXPECT_NEAR(patch.bound.lateral_half_width(), contact.lateral_half_width(), 1e-12);
  EXPECT_NEAR(patch.bound.peak(), 0.3 * contact.peak_pressure(), 1e-9);
}

TEST(PatchScene, TakesResultantsInNewtons) {
  const SteadyPatch patch = patch_of(
      ellipse, {"load.force=-1.5 kN", "load.lateral_creepage=", "load.lateral_force_ratio=0.2",
                "load.spin=", "load.spin_moment=3 N m"});
  const double full = 2.0 / 3 * pi * 24 * 300;
  EXPECT_EQ(patch.load[0], (PatchComponent{true, -1500}));
  EXPECT_NEAR(patch.load[1].value, 0.2 * full, 1e-9);
  EXPECT_EQ(patch.load[2], (PatchComponent{true, 3000}));
}

// Numbers in pascals and newtons that are none in the units of keys.
TEST(PatchScene, WarnsOfABoundThatIsLargeBesideTheModulus) {
  const auto warnings = [](const std::vector<std::string>& settings) {
    Scene scene = scene_of(ellipse);
    for (const std::string& setting : settings) scene.set(setting);
    read_model(scene);
    std::string lines;
    for (const Warning& warning : scene.warnings()) lines += warning.line;
    return lines;
  };
  EXPECT_EQ(warnings({"contact.peak_traction=4000"}), "");
  EXPECT_EQ(warnings({"contact.peak_traction=300 MPa"}), "");
  EXPECT_EQ(warnings({"contact.peak_traction=4001"}),
            "contact.peak_traction = 4001: the largest traction, 4e+03 N/mm^2, is 0.05 of the "
            "shear modulus, 80000 N/mm^2, and strains have to be small; numbers without a unit are "
            "in N, mm and "
            "N/mm^2");
  EXPECT_TRUE(warnings({"contact.peak_traction=3e8"}).starts_with("contact.peak_traction = 3e8: "));
  EXPECT_TRUE(
      warnings({"contact.peak_traction=", "contact.normal_load=8e7", "contact.friction=0.3"})
          .starts_with("contact.normal_load = 8e7: the largest traction"));
  // Normalised.
  EXPECT_EQ(warnings({"material.shear_modulus=1", "contact.peak_traction=1"}), "");
  EXPECT_EQ(warnings({"material.shear_modulus=1e12", "contact.peak_traction=1e12"}), "");
}

// Rows and elements grow smoothly from the circle to both sides.
TEST(PatchScene, HasRowsAndElementsThatFit) {
  Eigen::Index elements = 0;
  for (const double b : {60.0, 30.0, 12.0, 6.0, 3.0, 1.2, 0.6}) {
    const SteadyPatch patch =
        patch_of(ellipse, {"contact.lateral_half_width=" + std::to_string(b)});
    EXPECT_GT(patch.elements, elements);
    elements = patch.elements;
    EXPECT_GE(patch.rows * patch.elements, 250);
    EXPECT_LE(patch.rows * patch.elements, 520);
    if (b == 6) {
      EXPECT_EQ(patch.rows, patch.elements);
    }
  }
}

TEST(PatchScene, HasACostAndAnExplanation) {
  const Model model = patch_of(ellipse, {"grid.rows=10", "grid.elements=20"});
  EXPECT_EQ(elements_of(model), 20);
  EXPECT_EQ(steps_needed(model), 0);
  EXPECT_NEAR(memory_needed(model), 1e7, 0.5e7);
  EXPECT_GT(work_needed(model), 1e7);
  EXPECT_EQ(explain(model).title,
            "steady rolling of an ellipse under a creepage along the rolling, a creepage across "
            "it, a spin about the normal");
  EXPECT_EQ(unit_of_key("load.force", true), "N");
  EXPECT_EQ(unit_of_key("load.force"), "N/mm");
}

}  // namespace microslip::patch_scene_test
