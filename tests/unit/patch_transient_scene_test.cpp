// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a patch as scenes give them: starts, loads that change, lengths of steps.
#include <fmt/core.h>
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
  EXPECT_EQ(read.loads.at(0), (PatchLoad{{{false, 0}, {true, 0}, {false, 2e-4}}}));
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
  expect_refused({"step.scheme=fractional"},
                 "step.scheme = 'fractional': expected remembered, direct or relaxed");
  expect_refused({"step.relaxation=1"}, "it is for step.scheme relaxed");
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

TEST(PatchTransientScene, WarnsOfMotionsInARunThatAreNotSmall) {
  const Settings run{"load.file=run", "load.force=", "load.spin="};
  EXPECT_TRUE(warnings_of(run, "q,creepage,spin\n0,0,0\n20,0.01,0.002\n").empty());
  const auto told = warnings_of(run, "q,creepage,spin\n0,0,0\n9,-0.3,0.2\n20,0.1,0\n");
  ASSERT_EQ(told.size(), 2);
  EXPECT_EQ(told[0].find("creepage of load.file = -0.3: creepages above 0.2"), 0U) << told[0];
  EXPECT_EQ(told[1].find("spin of load.file = 0.2: the slip by this spin, up to 0.98"), 0U)
      << told[1];
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
  refused("q,creepage,normal_load\n0,0,1\n20,0,1\n",
          "column 'normal_load': expected contact.normal_load to be given");
  refused("q,lateral_force\n0,0\n20,9e9\n", "row 2: lateral_force = 9e+09: expected less");
  refused("q,force,lateral_force\n0,0,0\n20,12e3,12e3\n", "row 2: lateral_force");
  refused("q,spin\n0,0\n20,1e9\n", "row 2: spin = 1e+09: expected at most", "load.creepage=0");
  refused("q,spin\n0,0\n0,1\n20,x\n", "line 4", "load.creepage=0");
  refused("q,creepage\n0,0\n5,0\n", "motion.distance = 12: expected at most the distance");
  refused("q,Fy\n0,0\n20,1\n", "lateral_force = Fy");
}

const Settings loaded{
    "load.file=run",        "load.force=", "contact.peak_traction=", "contact.normal_load=50 kN",
    "contact.friction=0.3", "step.ratio="};

Settings loaded_with(const Settings& more) {
  Settings all = loaded;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(PatchTransientScene, ChangesItsContactByHertz) {
  const std::string rows =
      "q,force [kN],normal_load [kN],friction\n0,1,50,0.3\n6,1,400,0.3\n12,1,50,0.15\n";
  const PatchTransient read = transient_of(loaded, rows);
  EXPECT_TRUE(read.loads.changes_size());
  EXPECT_EQ(read.loads.contact_at(0), ContactScale{});
  EXPECT_NEAR(read.loads.contact_at(6).half_width, 2, 1e-15);
  EXPECT_NEAR(read.loads.contact_at(6).bound, 2, 1e-15);
  EXPECT_NEAR(read.loads.contact_at(12).bound, 0.5, 1e-15);
  const Settings steps = loaded_with({"step.ratio=0.5"});
  const std::string of_one_size = "q,force [kN],friction\n0,1,0.3\n6,1,0.3\n12,1,0.15\n";
  EXPECT_GT(work_needed(transient_of(steps, rows)),
            1.4 * work_needed(transient_of(steps, of_one_size)));
}

TEST(PatchTransientScene, ChangesItsHalfWidthsAndItsPeak) {
  const PatchTransient read =
      transient_of({"load.file=run", "load.force=", "step.ratio="},
                   "q,creepage,half_width,peak_traction [MPa]\n0,0,6,300\n6,0,9,600\n12,0,9,600\n");
  EXPECT_EQ(read.loads.contact_at(12), (ContactScale{.half_width = 1.5, .bound = 2}));
}

// Full sliding of the contact is 2/3 pi a b 300 MPa = 15.1 kN; it is as the square of the size, and
// so 9 times as large with a bound that is, too, 2.25 times as large.
TEST(PatchTransientScene, CarriesTheResultantsOfItsContact) {
  const Settings settings{"load.file=run", "load.force=", "load.spin=", "step.ratio="};
  const std::string grown = "q,force,half_width\n0,30e3,9\n12,33e3,9\n";
  EXPECT_EQ(transient_of(settings, grown).loads.at(12)[0].value, 33e3);
  expect_refused(settings, "row 2: force = 35000: expected less than full sliding, 33929",
                 "q,force,half_width\n0,30e3,9\n12,35e3,9\n");
  Settings constant = settings;
  constant.emplace_back("load.lateral_force=20 kN");
  EXPECT_NO_THROW(transient_of(constant, "q,creepage,half_width\n0,0,9\n12,0,9\n"));
  expect_refused(constant, "row 2: load.lateral_force = 20000: expected less than full sliding",
                 "q,creepage,half_width\n0,0,9\n12,0,6\n");
  Settings shifted = settings;
  shifted.insert(shifted.end(), {"start.type=cattaneo", "start.force=16 kN"});
  EXPECT_NO_THROW(transient_of(shifted, "q,creepage,half_width\n0,0,9\n12,0,6\n"));
  expect_refused(shifted, "start.force = 16000: expected less than full sliding, 15079",
                 "q,creepage,half_width\n0,0,6\n12,0,9\n");
  expect_refused(settings, "row 1: spin_moment = 50000: expected less than the moment of turning",
                 "q,spin_moment,half_width\n0,5e4,6\n12,5e4,9\n");
  EXPECT_NO_THROW(transient_of(settings, "q,spin_moment,half_width\n0,5e4,9\n12,5e4,9\n"));
}

TEST(PatchTransientScene, RefusesContactsThatDoNotChangeSo) {
  const auto refused = [&](const std::string& columns, const std::string& rows,
                           const std::string& error, const Settings& more = {}) {
    expect_refused(loaded_with(more), error, "q,creepage," + columns + "\n" + rows);
  };
  refused("friction", "0,0,-0.1\n20,0,0.3\n", "row 1: friction = -0.1: expected a number >= 0");
  refused("normal_load", "0,0,5e4\n20,0,1e11\n",
          "row 2: normal_load = 1e+11: expected half-widths 1e-4 ... 100 times");
  refused("friction", "0,0,0.3\n20,0,1e-8\n",
          "row 2: friction = 1e-08: expected a bound 1e-6 ... 1e6 times");
  refused("normal_load", "0,0,5e4\n20,0,1e5\n", "step.scheme = 'direct': expected remembered",
          {"step.scheme=direct"});
  refused("friction", "0,0,0.3\n20,0,0.2\n", "step.scheme = 'direct': expected remembered",
          {"step.scheme=direct"});
  refused("peak_traction", "0,0,300\n20,0,200\n", "expected contact.peak_traction to be given");
  refused("normal_load,half_width", "0,0,5e4,6\n20,0,5e4,6\n", "half_width and peak_traction, or");
  refused("normal_load", "0,0,5e4\n0,0,6e4\n20,0,6e4\n",
          "row 2: normal_load = 60000: expected 50000 of the row before");
  refused("half_width", "0,0,0\n1e7,0,6\n", "step.ratio = 0.5: expected another one: a step would",
          {"step.ratio=0.5", "motion.distance=20"});
}

TEST(PatchTransientScene, HasOneSizeByAFile) {
  const auto scene = [](const std::string& rows, const Settings& more) {
    Scene read = scene_of(ellipse);
    read.read_files_by([rows](const std::string& name) {
      return name == "patch" ? "y,trailing,leading\n-1,0,0\n0,-1,1\n1,0,0\n" : rows;
    });
    for (const char* setting :
         {"contact.half_width=", "contact.lateral_half_width=", "contact.patch_file=patch",
          "load.force=", "load.file=run", "step.ratio=", "grid.rows=", "grid.elements="}) {
      read.set(setting);
    }
    for (const std::string& setting : more) read.set(setting);
    return std::get<PatchTransient>(read_model(read));
  };
  const Settings by_load{"contact.normal_load=100", "contact.friction=0.3",
                         "contact.peak_traction="};
  EXPECT_EQ(scene("q,creepage,peak_traction\n0,0,300\n20,0,150\n", {}).loads.contact_at(20).bound,
            0.5);
  EXPECT_EQ(scene("q,creepage,friction\n0,0,0.3\n20,0,0.6\n", by_load).loads.contact_at(20).bound,
            2);
  const auto error_of = [&](const std::string& rows, const Settings& more) {
    return message_in_keys([&] { scene(rows, more); });
  };
  EXPECT_NE(error_of("q,creepage,half_width\n0,0,1\n20,0,1\n", {})
                .find("column 'half_width': expected none, as the contact of contact.patch_file"),
            std::string::npos);
  EXPECT_NE(error_of("q,creepage,normal_load\n0,0,100\n20,0,101\n", by_load)
                .find("row 2: normal_load = 101: expected that of the scene"),
            std::string::npos);
}

TEST(PatchTransientScene, IsWarnedOfStepsThatMissTheContact) {
  const std::string rows = "q,creepage,half_width\n0,0,6\n1,0,7\n2,0,5\n20,0,6\n";
  const Settings settings{"load.file=run", "load.force=", "start.type=rest", "step.ratio=1"};
  const auto warnings = warnings_of(settings, rows);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].find("step.ratio = 1: row 2 of load.file lies within a step"), 0U)
      << warnings[0];
  EXPECT_EQ(warnings[0].find("step.tolerance"), std::string::npos) << warnings[0];
  const auto of_small = warnings_of({"load.file=run", "load.force=", "step.ratio=1"},
                                    "q,creepage,half_width\n0,0,6\n6,0,2\n20,0,6\n");
  ASSERT_EQ(of_small.size(), 1U);
  EXPECT_NE(of_small[0].find("above half of the least half-width, 1 mm"), std::string::npos)
      << of_small[0];
}

TEST(PatchTransientScene, HasUnderRelaxationOfStepsUpToItsLength) {
  const Settings relaxed{"step.scheme=relaxed", "step.ratio=0.5 1"};
  const auto with = [&](const std::string& more) {
    Settings all = relaxed;
    all.push_back(more);
    return all;
  };
  EXPECT_EQ(std::get<Relaxed>(transient_of(relaxed).scheme).step_ratio, 1);
  EXPECT_EQ(std::get<Relaxed>(transient_of(with("step.relaxation=1.5")).scheme).step_ratio, 1.5);
  expect_refused(with("step.relaxation=0.9"), "step.ratio = 1: expected at most step.relaxation");
  expect_refused(with("step.relaxation=0"), "step.relaxation = 0: expected");
  expect_refused(with("step.relaxation=2e6"), "step.relaxation = 2e+06: expected at most 1e6");
  expect_refused(
      {"step.scheme=relaxed", "load.file=run", "load.force=", "step.ratio=", "motion.distance="},
      "step.relaxation = 1: expected at least the c of the steps from row to row of load.file, 4",
      "q,force\n0,0\n6,10\n12,20\n");
}

/// Tractions on 5 by 5 points of the ellipse, a fraction of the bound along the rolling.
std::string tractions_of(double fraction) {
  std::string rows = "x,y,traction_x,traction_y\n";
  for (int k = -2; k <= 2; ++k) {
    for (int i = -2; i <= 2; ++i) {
      const double y = 0.4 * k, s = 0.4 * i;
      const double x = s * std::sqrt(1 - y * y);
      rows +=
          fmt::format("{},{},{},0\n", 6 * x, 4 * y, fraction * 300 * std::sqrt(1 - x * x - y * y));
    }
  }
  return rows;
}

TEST(PatchTransientScene, BeginsUnderTractionsOfAFile) {
  const double full = 2.0 / 3 * M_PI * 6 * 4 * 300;
  const Settings file{"start.type=file", "start.file=tractions", "load.spin="};
  const PatchTransient read = transient_of(file, tractions_of(-4000 / full));
  ASSERT_TRUE(read.start);
  EXPECT_NEAR((*read.start)(1, 2)[0], -4000 / full, 1e-12);
  EXPECT_TRUE(warnings_of(file, tractions_of(-4000 / full)).empty());
  const auto warnings = warnings_of(file, tractions_of(-2000 / full));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].find("load.force = -4000: from the tractions of start.file, which carry "
                             "-2e+03, it is reached over the first step, of 1.5 mm"),
            0U)
      << warnings[0];
  expect_refused(file, "start.file = 'tractions': row 1: traction = ", tractions_of(-1.1));
  expect_refused(file, "start.file = 'tractions': line 1: expected a column 'traction_y'",
                 "x,y,traction_x\n0,0,0\n");
  expect_refused(file, "number of y with tractions = 1: expected three or more",
                 "x,y,traction_x,traction_y\n0,0,0,0\n");
  expect_refused({"start.type=file"}, "missing key 'start.file'");
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

// At 0.3 a and a strong spin, forces are off by up to 4 % of full sliding where the size changes.
TEST(PatchTransientScene, IsWarnedOfLongStepsUnderAStrongSpinWhereTheContactChanges) {
  const auto warnings = [](const std::string& ratio, const std::string& spin) {
    return warnings_of({"load.file=run", "load.force=", "load.spin=", "contact.peak_traction=",
                        "contact.normal_load=50 kN", "contact.friction=0.3", "grid.elements=12",
                        "step.ratio=" + ratio},
                       "q,spin,normal_load\n0," + spin + ",50000\n20," + spin + ",51000\n");
  };
  const auto of_long = warnings("2", "0.01");
  ASSERT_EQ(of_long.size(), 1U);
  EXPECT_EQ(
      of_long[0],
      "step.ratio = 2: steps are up to 2 mm long: above 0.25 of the half-width, 1.5 mm, forces "
      "may have errors of more than 1 % of full sliding where a contact changes its size under "
      "a strong spin");
  EXPECT_TRUE(warnings("1", "0.01").empty());
  EXPECT_TRUE(warnings("2", "0.0001").empty());
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
