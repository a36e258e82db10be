// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that are given by load and radii, and loads that are ratios: what does not go together.
#include <string>

#include "robustness/bad_scenes.hpp"

namespace microslip::bad_contacts_test {

const std::string loaded_contact = R"(
problem steady
material { youngs_modulus 2
  poisson_ratio 0.3 }
contact { normal_load 0.01
  radius_1 100
  friction 0.3 }
kernel { type plane
  length 40 }
grid { elements 20 }
load { force_ratio -0.5 }
)";

TEST_F(BadScenes, ContactsFromLoadsAndRadii) {
  const auto rejected = [&](const std::string& setting, const std::string& named) {
    expect_rejected(loaded_contact, "--set '" + setting + "'", named);
  };
  rejected("contact.radius_1=", "missing key 'contact.radius_1'");
  rejected("contact.friction=", "missing key 'contact.friction'");
  rejected("contact.normal_load=", "missing key 'contact.half_width' or 'contact.normal_load'");
  for (const std::string key :
       {"half_width=1", "peak_traction=1", "bound_polynomial=1", "bound_file=b.tsv"}) {
    const std::string other = "contact." + key.substr(0, key.find('='));
    const Outcome outcome = run(loaded_contact, "--set contact." + key);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.error.find("expected only one of "), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("'" + other + "'"), std::string::npos) << outcome.error;
  }
  expect_rejected(good_scene, "--set contact.radius_1=100",
                  "key 'contact.radius_1' has no role here: it is for scenes with contact.normal");
  for (const std::string key : {"normal_load", "radius_1", "friction"}) {
    for (const std::string value : {"0", "-1", "1e-51", "nan"}) {
      rejected("contact." + key + "=" + value, "contact." + key + " = ");
    }
  }
  rejected("contact.friction=30", "contact.friction = 30: expected a number above 0, at most 10");
  rejected("contact.normal_load=60 kN", "expected a number in N/mm or another of its kind");
  rejected("contact.radius_2=0", "contact.radius_2 = 0: expected a number > 0");
  for (const std::string radius : {"-100", "-99", "-1"}) {
    rejected("contact.radius_2=" + radius, "contact.radius_2 = " + radius +
                                               ": expected a number > 0, or for a concave body "
                                               "one below -100");
  }
  rejected("contact.normal_load=1e4",
           "contact.normal_load = 10000: expected a load under which the half-width, ");
  rejected("material.shear_modulus=1",
           "expected only one of 'material.shear_modulus' and 'material.youngs_modulus'");
  rejected("material.youngs_modulus=0", "material.youngs_modulus = 0: expected a number > 0");
  rejected("material.poisson_ratio=-1", "material.poisson_ratio = -1: expected a number in [0");
  rejected("material.shear_modulus_1=0.4",
           "key 'material.shear_modulus_1': expected 'material.shear_modulus' for the driven body");
  rejected("material.poisson_ratio_2=0.4",
           "missing key 'material.shear_modulus_2' or 'material.youngs_modulus_2'");
  EXPECT_NE(run(loaded_contact, "--set contact.radius_2=-101")
                .error.find(": warning: contact.normal_load"),
            std::string::npos);
  EXPECT_EQ(run(loaded_contact, "").error, "");
}

// In tables and in explain, with the units of the keys that they would have.
TEST_F(BadScenes, WhatFollowsFromLoadsAndRadiiIsShown) {
  ASSERT_EQ(run(loaded_contact, "").error, "");
  const std::string summary = text_of(out() / "summary.tsv");
  for (const char* key : {"material.shear_modulus = 0.769230769230769", "load.force = -0.0015",
                          "contact.half_width = 1.0764", "contact.peak_traction = 0.001774"}) {
    EXPECT_NE(summary.find(std::string("#   derived ") + key), std::string::npos) << key;
  }
  const std::string explained =
      run_command(MICROSLIP_BIN "/microslip explain '" + scene_file().string() + "'").output;
  EXPECT_NE(explained.find("  derived contact.half_width      1.0764"), std::string::npos);
  EXPECT_NE(explained.find(" mm         half-width a of the contact\n"), std::string::npos)
      << explained;
}

TEST_F(BadScenes, ACylinderIsOneOfTheBodies) {
  const std::string scene = "problem cylinder" + good_contact + R"(
cylinder { mass 1
  inertia 5000
  radius 10 cm
  slope_force 0.0003 }
motion { distance 0.33 }
)";
  const std::string loaded =
      "--set contact.half_width= --set contact.peak_traction= --set contact.normal_load=0.01 "
      "--set contact.friction=0.3 --set contact.radius_1=";
  EXPECT_EQ(run(scene, loaded + "100").error, "");
  EXPECT_EQ(run(scene, loaded + "200 --set 'contact.radius_2=0.1 m'").error, "");
  EXPECT_TRUE(run(scene, loaded + "200")
                  .error.ends_with("scene.info:12: warning: cylinder.radius = 100: differs from "
                                   "contact.radius_1 and contact.radius_2\n"));
}

TEST_F(BadScenes, LoadRatios) {
  const auto rejected = [&](const std::string& setting, const std::string& named) {
    expect_rejected(loaded_contact, "--set load.force_ratio= --set 'load." + setting + "'", named);
  };
  for (const std::string value : {"-1", "1", "1.5", "-20"}) {
    rejected("force_ratio=" + value,
             "load.force_ratio = " + value + ": expected a number above -1, below 1");
  }
  for (const std::string value : {"0", "1", "-0.6", "6"}) {
    rejected("stick_ratio=" + value, "load.stick_ratio = " + value + ": expected a number above 0");
  }
  rejected("force_ratio=0.5 N", "load.force_ratio = '0.5 N': expected");
  rejected("stick_ratio=0.5' --set 'load.force=1",
           "expected only one of 'load.force' and 'load.stick_ratio'");
  rejected("stick_ratio=0.5' --set kernel.length= --set kernel.type=strip --set 'kernel.width=1",
           "load.stick_ratio = 0.5: expected kernel.type plane without a layer");
  expect_rejected(good_scene,
                  "--set load.creepage= --set load.stick_ratio=0.5 --set "
                  "contact.bound_polynomial=1",
                  "load.stick_ratio = 0.5: expected Hertz's bound, as it is Carter's");
}

}  // namespace microslip::bad_contacts_test
