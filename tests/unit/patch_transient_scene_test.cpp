// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a patch as scenes give them: starts, loads that change, lengths of steps.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "microslip/scene/cost.hpp"
#include "microslip/scene/explanation.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::patch_transient_scene_test {

const std::string ellipse = R"(
problem transient
material { shear_modulus 80 GPa
  poisson_ratio 0.3 }
contact { half_width 6 mm
  lateral_half_width 4 mm
  peak_traction 300 MPa }
grid { rows 6
  elements 8 }
load { force -4 kN
  spin 0.2 1/m }
start { type rest }
step { ratio 1 }
motion { distance 12 mm }
)";

using Settings = std::vector<std::string>;

Scene scene_with(const Settings& settings, const std::string& rows) {
  Scene scene = scene_of(ellipse);
  scene.read_files_by([rows](const std::string&) { return rows; });
  for (const std::string& setting : settings) scene.set(setting);
  return scene;
}

/// \param rows  of the file of load.file
PatchTransient transient_of(const Settings& settings, const std::string& rows = "") {
  Scene scene = scene_with(settings, rows);
  const Model model = read_model(scene);
  scene.reject_unread();
  return std::get<PatchTransient>(model);
}

std::vector<std::string> warnings_of(const Settings& settings, const std::string& rows = "") {
  Scene scene = scene_with(settings, rows);
  read_model(scene);
  std::vector<std::string> lines;
  for (const Warning& warning : scene.warnings()) lines.push_back(warning.line);
  return lines;
}

void expect_refused(const Settings& settings, const std::string& error,
                    const std::string& rows = "") {
  const std::string found = message_in_keys([&] { transient_of(settings, rows); });
  EXPECT_NE(found.find(error), std::string::npos) << found << "\n  not " << error;
}

TEST(PatchTransientScene, HasStepsOfItsMeanCell) {
  const PatchTransient read = transient_of({"step.ratio=1 0.5"});
  EXPECT_EQ(read.spacing(), 1.5);
  EXPECT_EQ(read.step_lengths(), (std::vector<double>{1.5, 0.75}));
  EXPECT_EQ(read.distance, 12);
  EXPECT_TRUE(read.shifts.empty());
  EXPECT_EQ(read.loads.between(3, 4), (PatchLoad{{{true, -4000}, {false, 0}, {false, 2e-4}}}));
  EXPECT_EQ(steps_needed(read), 11);
}

TEST(PatchTransientScene, IsShiftedToTheResultantsOfItsLoad) {
  const PatchTransient read = transient_of({"start.type=cattaneo"});
  ASSERT_EQ(read.shifts.size(), 1U);
  EXPECT_EQ(read.shifts[0], (PatchLoad{{{true, -4000}, {false, 0}, {false, 0}}}));
}

TEST(PatchTransientScene, IsShiftedByLengthsAndToResultantsInTurn) {
  const PatchTransient read =
      transient_of({"start.type=cattaneo", "start.force=1 -1 kN", "start.lateral_shift=1 2 um",
                    "start.rotation=0.001 0 rad"});
  ASSERT_EQ(read.shifts.size(), 2U);
  EXPECT_EQ(read.shifts[0], (PatchLoad{{{true, 1000}, {false, 0.001}, {false, 0.001}}}));
  EXPECT_EQ(read.shifts[1], (PatchLoad{{{true, -1000}, {false, 0.002}, {false, 0}}}));
}

TEST(PatchTransientScene, TakesForComponentsTheColumnsOfAFile) {
  const std::string rows = "q,creepage,lateral_force [kN]\n0,0,0\n6,0.002,1\n12,0.002,3\n";
  const PatchTransient read =
      transient_of({"load.file=run", "load.force=", "step.ratio=", "motion.distance="}, rows);
  EXPECT_EQ(read.distance, 12);
  EXPECT_EQ(read.step_ratios, (std::vector<double>{4, 4}));
  const PatchLoad load = read.loads.between(3, 9);
  EXPECT_FALSE(load[0].by_resultant);
  EXPECT_NEAR(load[0].value, 0.00175, 1e-15);
  EXPECT_TRUE(load[1].by_resultant);
  EXPECT_NEAR(load[1].value, 2000, 1e-9);
  EXPECT_EQ(load[2], (PatchComponent{false, 2e-4}));
  EXPECT_EQ(read.patch.load, (PatchLoad{{{false, 0}, {true, 0}, {false, 2e-4}}}));
}

TEST(PatchTransientScene, TakesTimesAndAnAngularVelocity) {
  const std::string rows = "t,v [m/s],omega,spin_moment\n0,1,10,0\n0.012,1,9.9,5000\n";
  const PatchTransient read = transient_of(
      {"load.file=run", "load.force=", "load.spin=", "load.radius=100", "motion.distance="}, rows);
  const PatchLoad load = read.loads.between(0, 12);
  EXPECT_NEAR(load[0].value, 0.005, 1e-12);
  EXPECT_EQ(load[2], (PatchComponent{true, 5000}));
  EXPECT_NEAR(read.loads.time_at(6).value_or(0), 0.006, 1e-15);
}

TEST(PatchTransientScene, IsRefusedInOneLineThatNamesTheKey) {
  expect_refused({"step.ratio=-1"}, "step.ratio = -1: expected numbers >= 1e-15 or 0");
  expect_refused({"step.ratio=nan"}, "step.ratio = 'nan': expected finite numbers");
  expect_refused({"step.ratio=1e-6", "motion.distance=0.5"},
                 "step.ratio = 1e-06: expected a number from ");
  expect_refused({"step.ratio=1e9"}, "step.ratio = 1e+09: expected a number from ");
  expect_refused({"motion.distance=0"}, "motion.distance = 0: expected");
  expect_refused({"motion.distance=3 km"}, "motion.distance = 3e+06: expected at most 1e+06 steps");
  expect_refused({"motion.distance=12.0000003"}, "the last step would be 3e-07 mm long");
  expect_refused({"step.scheme=relaxed"}, "step.scheme = 'relaxed': expected remembered or direct");
  expect_refused({"start.type=file"}, "start.type = 'file': expected rest or cattaneo");
  expect_refused({"start.force=1"},
                 "key 'start.force' has no role here: it is for start.type cattaneo");
  expect_refused({"kernel.type=plane"}, "it is for line contacts, not for this ellipse");
  expect_refused({"step.tolerance=0.01"}, "not for this ellipse");
  expect_refused({"problem=steady", "start.type=", "motion.distance="},
                 "key 'step.ratio' has no role here: it is for problem transient");
  expect_refused({"load.force=", "load.spin="}, "missing key 'load.creepage' or ");
  expect_refused({"load.force=20 kN"}, "load.force = 20000: expected less than full sliding, ");
}

TEST(PatchTransientScene, HasNoShiftsBeyondFrictionOrOfOtherNumbers) {
  const std::string cattaneo = "start.type=cattaneo";
  expect_refused({cattaneo, "start.lateral_force=20 kN"},
                 "start.lateral_force = 20000: expected less than full sliding, ");
  expect_refused({cattaneo, "start.spin_moment=1e9"}, "start.spin_moment = 1e+09: expected less");
  expect_refused({cattaneo, "start.lateral_shift=1e9"},
                 "start.lateral_shift = 1e+09: expected at most");
  expect_refused({cattaneo, "start.force=1", "start.shift=1"},
                 "expected only one of 'start.shift' and 'start.force'");
  expect_refused({cattaneo, "start.force=1 2", "start.rotation=1"},
                 "start.rotation = 1: expected 2 numbers, as start.force has");
  expect_refused({cattaneo, "load.force=", "load.creepage=0.001"}, "missing key 'start.force' or ");
}

TEST(PatchTransientScene, HasNoRunsThatDoNotFit) {
  const Settings settings{"load.file=run", "load.force=", "load.spin="};
  const auto refused = [&](const std::string& rows, const std::string& error,
                           const std::string& setting = "load.spin=0") {
    Settings all = settings;
    all.push_back(setting);
    expect_refused(all, error, rows);
  };
  refused("q,spin,spin_moment\n0,0,0\n20,0,0\n", "expected only one of spin, spin_moment",
          "load.creepage=0");
  refused("q,creepage\n0,0\n20,0\n",
          "expected only one of 'load.creepage' and column 'creepage' of load.file",
          "load.creepage=0");
  refused("q,other\n0,0\n20,0\n", "expected creepage, force, omega, lateral_creepage");
  refused("q,creepage,normal_load\n0,0,1\n20,0,1\n", "column 'normal_load': expected none");
  refused("q,lateral_force\n0,0\n20,9e9\n", "row 2: lateral_force = 9e+09: expected less");
  refused("q,force,lateral_force\n0,0,0\n20,12e3,12e3\n", "row 2: lateral_force");
  refused("q,spin\n0,0\n20,1e9\n", "row 2: spin = 1e+09: expected at most", "load.creepage=0");
  refused("q,spin\n0,0\n0,1\n20,x\n", "line 4", "load.creepage=0");
  refused("q,lateral_force\n0,0\n0,1\n20,1\n",
          "row 2: lateral_force = 1: expected 0 of the row before");
  refused("q,creepage\n0,0\n5,0\n", "motion.distance = 12: expected at most the distance");
  refused("q,Fy\n0,0\n20,1\n", "lateral_force = Fy");
}

TEST(PatchTransientScene, IsWarnedOfForcesAtOnceAndOfOtherSteps) {
  const auto warnings = warnings_of({"step.ratio=0.2", "step.scheme=direct"});
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].find("step.ratio = 0.2: this scheme is safe from 0.5"), 0U) << warnings[0];
  EXPECT_EQ(warnings[1].find("load.force = -4000: from a start at rest"), 0U) << warnings[1];
  EXPECT_TRUE(warnings_of({"start.type=cattaneo"}).empty());
  EXPECT_TRUE(warnings_of({"start.type=cattaneo", "step.ratio=2"}).empty());
  const auto of_long = warnings_of({"start.type=cattaneo", "step.ratio=1 2.2"});
  ASSERT_EQ(of_long.size(), 1U);
  EXPECT_EQ(of_long[0].find("step.ratio = 1 2.2: steps are up to 3.3 mm long"), 0U) << of_long[0];
  const auto of_file =
      warnings_of({"load.file=run", "load.force="}, "q,lateral_force\n0,100\n20,100\n");
  ASSERT_EQ(of_file.size(), 1U);
  EXPECT_EQ(of_file[0].find("lateral_force of load.file = 100: from"), 0U) << of_file[0];
}

TEST(PatchTransientScene, HasACostAndAnExplanation) {
  const PatchTransient read = transient_of({"start.type=cattaneo"});
  const Explanation explained = explain(read);
  EXPECT_EQ(
      explained.title,
      "transient rolling of an ellipse under a force along the rolling, a creepage across it, "
      "a spin about the normal");
  EXPECT_EQ(elements_of(read), 8);
  EXPECT_GT(work_needed(read), 1e6);
  EXPECT_GT(memory_needed(read), memory_needed(read.patch));
}

}  // namespace microslip::patch_transient_scene_test
