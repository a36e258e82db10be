// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that falls with slip as it is typed: results, warnings of a second solution, and what is
// refused.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "robustness/executables.hpp"

namespace microslip::falling_friction_scenes_test {

constexpr const char* steady = R"(problem steady
material { shear_modulus 82 GPa
           poisson_ratio 0.28 }
contact  { half_width 4 mm
           peak_traction 148.6 MPa
           friction_law exponential
           kinetic_ratio 0.6
           half_speed 100 mm/s }
kernel   { type plane
           length 200 }
grid     { elements 41 }
load     { creepage -0.001
           speed 45 m/s }
)";

const std::string steps =
    "--set problem=transient --set step.ratio=0.2 --set motion.distance=6 --set "
    "start.type=cattaneo "
    "--set start.force=540 ";

class FallingFrictionScenes : public Executables {
 protected:
  void SetUp() override {
    Executables::SetUp();
    std::ofstream(folder_ / "scene.info") << steady;
  }

  Outcome solve(const std::string& words) const {
    return run_in_folder("scene.info --quiet " + words);
  }

  /// \param error  behind the program's name
  void expect_refused(const std::string& words, const std::string& error, int status = 1) const {
    const Outcome outcome = solve(words);
    EXPECT_EQ(outcome.status, status) << words;
    EXPECT_EQ(outcome.error.find("microslip: " + error), 0U) << outcome.error;
    EXPECT_EQ(outcome.error.find('\n'), outcome.error.size() - 1) << outcome.error;
    EXPECT_FALSE(fs::exists(folder_ / "out")) << words;
  }

  std::string summary() const { return text_of(folder_ / "out" / "summary.tsv"); }
};

TEST_F(FallingFrictionScenes, HaveOneSteadySolution) {
  const Outcome solved = solve("");
  EXPECT_EQ(solved.status, 0);
  EXPECT_EQ(solved.error, "");
  EXPECT_NE(summary().find("\nsecond_solution\t0\t1\nmethod\tcalibrated\t1\n"), std::string::npos);
}

TEST_F(FallingFrictionScenes, NameTheStepThatAShortMemoryLeavesWithoutASolution) {
  expect_refused(steps + "--set step.ratio=0.05 --set contact.friction_memory=0.0001",
                 "behind q = ", 2);
}

TEST_F(FallingFrictionScenes, WarnOfSecondSolutionsInShortStepsWithoutAMemory) {
  const Outcome at_once = solve(steps);
  EXPECT_EQ(at_once.status, 0);
  EXPECT_NE(at_once.error.find("there is a second solution, of bodies that slide faster"),
            std::string::npos)
      << at_once.error;
  EXPECT_EQ(summary().find("\nsteps_with_second_solution\t0\t"), std::string::npos);
  const Outcome remembers = solve(steps + "--set 'contact.friction_memory=3 um' --out out");
  EXPECT_EQ(remembers.status, 0);
  EXPECT_EQ(remembers.error, "");
  EXPECT_NE(summary().find("\nsteps_with_second_solution\t0\t"), std::string::npos);
}

TEST_F(FallingFrictionScenes, TakeTheSpeedOfARun) {
  std::ofstream(folder_ / "run.tsv")
      << "t [s]\tv [m/s]\tcreepage\n0\t45\t-0.001\n0.0002\t45\t-0.001\n0.0004\t30\t-0.0015\n";
  const std::string run =
      "--set problem=transient --set load.creepage= --set load.file=run.tsv --set start.type=rest "
      "--set 'contact.friction_memory=3 um' ";
  expect_refused(run,
                 "scene.info:13: key 'load.speed' has no role here: it is for scenes with "
                 "contact.friction_law, but for a load.file with times");
  EXPECT_EQ(solve(run + "--set load.speed=").status, 0);
}

TEST_F(FallingFrictionScenes, HaveACurveWithAMaximum) {
  ASSERT_EQ(run_in_folder("curve scene.info --points 9 --out out").status, 0);
  const std::string curve = text_of(folder_ / "out" / "curve.tsv");
  EXPECT_NE(curve.find("\ncreepage\tforce\tforce_ratio\tsecond_solution\tmethod\n"),
            std::string::npos);
  EXPECT_EQ(run_in_folder("plot out").status, 0);
}

TEST_F(FallingFrictionScenes, SayWhatIsRefused) {
  expect_refused("--set load.speed=", "missing key 'load.speed'");
  expect_refused("--set contact.kinetic_ratio=1.2",
                 "contact.kinetic_ratio = 1.2: expected a number in [0, 1]");
  expect_refused("--set contact.friction_law=falls",
                 "contact.friction_law = 'falls': expected linear or exponential or rational or "
                 "table");
  expect_refused("--set method=chebyshev", "scene.info:6: key 'contact.friction_law' has no role");
  expect_refused(steps + "--set step.scheme=direct --set contact.friction_memory=1",
                 "step.scheme = 'direct': expected remembered where friction has a memory");
  expect_refused("--set load.creepage= --set load.force=-900",
                 "friction that depends on slip: no creepage is found for the force", 2);
  const Outcome response = run_in_folder("response scene.info --out out");
  EXPECT_EQ(response.status, 1);
  EXPECT_NE(response.error.find("but friction depends on slip"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  const std::string explained = run_in_folder("explain scene.info").output;
  EXPECT_NE(explained.find("friction falls with slip to 0.6 of that at rest, at once"),
            std::string::npos);
  EXPECT_EQ(explained.find("friction that depends on slip"), std::string::npos);
}

class FallingPatchScenes : public FallingFrictionScenes {
 protected:
  void SetUp() override {
    FallingFrictionScenes::SetUp();
    std::ofstream(folder_ / "scene.info") << R"(problem steady
material { shear_modulus 82 GPa
           poisson_ratio 0.28 }
contact  { half_width 4 mm
           lateral_half_width 5 mm
           peak_traction 148.6 MPa
           friction_law exponential
           kinetic_ratio 0.6
           half_speed 100 mm/s }
grid     { rows 5
           elements 8 }
load     { creepage -0.001
           speed 45 m/s }
)";
  }
};

const std::string rolls =
    "--set problem=transient --set step.ratio=0.2 --set motion.distance=9.5 --set start.type=rest ";

TEST_F(FallingPatchScenes, AreSolvedSteadilyAndInSteps) {
  const Outcome solved = solve("");
  EXPECT_EQ(solved.status, 0);
  EXPECT_EQ(solved.error, "");
  EXPECT_NE(summary().find("\nsecond_solution\t0\t1\n"), std::string::npos);
  const Outcome at_once = solve(rolls);
  EXPECT_EQ(at_once.status, 0);
  EXPECT_NE(at_once.error.find("there is a second solution, of bodies that slide faster"),
            std::string::npos)
      << at_once.error;
  EXPECT_EQ(summary().find("\nsteps_with_second_solution\t0\t1\n"), std::string::npos);
  const Outcome remembers = solve(rolls + "--set contact.friction_memory=0.002");
  EXPECT_EQ(remembers.status, 0);
  EXPECT_EQ(remembers.error, "");
  EXPECT_NE(summary().find("\nsteps_with_second_solution\t0\t1\n"), std::string::npos);
  const Outcome curve = run_in_folder("curve scene.info --set load.creepage= --quiet --out curve");
  EXPECT_EQ(curve.status, 0);
  EXPECT_NE(text_of(folder_ / "curve" / "curve.tsv").find("\tsecond_solution\t"),
            std::string::npos);
}

TEST_F(FallingPatchScenes, HaveOneSolutionWithTheMemoryThatIsSaidToBeEnough) {
  const Outcome explained = run_in_folder("explain scene.info " + rolls);
  EXPECT_NE(explained.output.find(" = 0.0058 mm is enough for one solution in each step"),
            std::string::npos)
      << explained.output;
  const std::string short_steps = rolls + "--set step.ratio=0.1 --set contact.friction_memory=";
  EXPECT_EQ(solve(short_steps + "0.0058").error, "");
  EXPECT_NE(solve(short_steps + "0.0001").error.find("with a longer contact.friction_memory"),
            std::string::npos);
}

// From 45 m/s the wheel slows down to 5 m/s. It rolls 9.5 mm, and slips more slowly at the end.
TEST_F(FallingPatchScenes, TakeTheSpeedOfARun) {
  std::ofstream(folder_ / "run.tsv")
      << "t\tv\tcreepage\n0\t45000\t-0.001\n1e-4\t45000\t-0.001\n3e-4\t5000\t-0.001\n";
  const std::string remembers = "--set contact.friction_memory=0.002 ";
  EXPECT_EQ(solve(rolls + remembers).error, "");
  const double fast = summary_value("force");
  const Outcome slower = solve(
      "--set problem=transient --set step.ratio=0.2 --set start.type=rest "
      "--set load.file=run.tsv --set load.speed= --set load.creepage= " +
      remembers);
  EXPECT_EQ(slower.error, "");
  EXPECT_GT(summary_value("force"), 1.005 * fast);
}

// Forces of steps come and go here without a second solution in any step.
TEST_F(FallingPatchScenes, WarnOfForcesThatGoBackAndForthWithoutAMemory) {
  const std::string fast =
      "--set problem=transient --set step.ratio=1 --set motion.distance=40 --set start.type=rest "
      "--set contact.half_width=5 --set contact.peak_traction=300 --set contact.kinetic_ratio=0.5 "
      "--set grid.rows=10 --set grid.elements=10 --set load.creepage=0.005 --set load.speed=20000 ";
  const Outcome at_once = solve(fast);
  EXPECT_EQ(at_once.status, 0);
  EXPECT_NE(at_once.error.find("forces go back and forth from step to step by 0."),
            std::string::npos)
      << at_once.error;
  const Outcome remembers = solve(fast + "--set contact.friction_memory=0.02");
  EXPECT_EQ(remembers.status, 0);
  EXPECT_EQ(remembers.error, "");
}

// A run that goes on from a state under less creepage loses its force step by step.
TEST_F(FallingPatchScenes, DoNotWarnOfAForceThatGoesOn) {
  const std::string mild = rolls + "--set step.ratio=1 --set contact.half_speed=20000 ";
  const Outcome begun = solve(mild + "--save begun.state");
  EXPECT_EQ(begun.error, "");
  const Outcome goes_on = solve(mild +
                                "--set start.type=state --set start.state=begun.state --set "
                                "motion.distance=19 --set load.creepage=-0.0002");
  EXPECT_EQ(goes_on.status, 0);
  EXPECT_EQ(goes_on.error, "");
}

TEST_F(FallingPatchScenes, AreRefusedWhereTheyAreNotSolved) {
  const std::string no_role =
      "scene.info:7: key 'contact.friction_law' has no role here: it is for problem steady or "
      "transient of bodies of one material";
  expect_refused(rolls + "--set step.scheme=direct", no_role);
  expect_refused("--set target_error=0.01 --set grid.rows= --set grid.elements=", no_role);
  expect_refused("--set load.creepage= --set load.force_ratio=0.97 --set contact.half_speed=10",
                 "friction that depends on slip: no solution is found, as friction falls too fast",
                 2);
  std::ofstream(folder_ / "run.tsv") << "q\tcreepage\n0\t-0.001\n2\t-0.001\n1\t-0.001\n";
  expect_refused(
      "--set problem=transient --set step.ratio=0.2 --set start.type=rest "
      "--set load.file=run.tsv --set load.creepage=",
      "scene.info:7: contact.friction_law = 'exponential': expected none where the rows "
      "of load.file turn");
}

}  // namespace microslip::falling_friction_scenes_test
