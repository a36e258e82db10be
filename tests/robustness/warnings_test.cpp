// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that are solved with a line on stderr, which is in the tables, too.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "robustness/executables.hpp"

namespace microslip::warnings_test {

class Warnings : public Executables {
 protected:
  Outcome run(const std::string& scene, const std::string& options) const {
    return run_program("microslip", "", scene, options);
  }
};

// Outside of safe ranges a scene is solved as asked for, with a line on stderr and in the tables.
TEST_F(Warnings, TellOfUnsafeValues) {
  const auto expect_warned = [&](const std::string& scene, const std::string& options,
                                 const std::string& line) {
    const Outcome outcome = run(scene, options);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.error.starts_with("microslip: warning: " + line + "\n")) << outcome.error;
    EXPECT_NE(text_of(out() / "summary.tsv").find("#   warning = " + line), std::string::npos);
  };
  const std::string standard = "--set leading_edge=standard --set grid.elements=51 ";
  expect_warned(good_scene, standard + "--set step.ratio=0.1",
                "step.ratio = 0.1: this scheme is safe from 0.7 to 1.5; leading_edge inversion is "
                "safe for any");
  expect_warned(good_scene, standard + "--set grid.elements=4",
                "grid.elements = 4: this scheme is safe from 11 on; leading_edge inversion is safe "
                "for any");
  expect_warned(
      good_scene, "--set leading_edge=calibrated --set grid.elements=4",
      "grid.elements = 4: this scheme is safe from 11 on; leading_edge inversion is safe for any");
  expect_warned(good_transient, "--set step.scheme=direct --set step.ratio=0.1",
                "step.ratio = 0.1: this scheme is safe from 0.5 to 1.3; step.scheme remembered "
                "is safe for any");
  const std::string direct = "--set step.scheme=direct --set step.ratio=1 --set motion.distance=";
  expect_warned(
      good_transient, direct + "0.23",
      "motion.distance = 0.23: cuts the last step to a step.ratio of 0.3, and the creepage "
      "of the summary is its creepage; direct is safe from 0.5 on, step.scheme remembered "
      "for any");
  EXPECT_EQ(run(good_transient, direct + "0.2").error, "");
  EXPECT_EQ(run(good_transient, direct + "0.23 --set step.scheme=remembered").error, "");
  // With the place on stderr alone: the tables are the same wherever the scene is.
  const Outcome of_file = run(good_scene + "leading_edge standard\nstep { ratio 0.1 }\n", "");
  const auto line = std::ranges::count(good_scene, '\n') + 2;
  const std::string doubt = "step.ratio = 0.1: this scheme";
  EXPECT_TRUE(of_file.error.starts_with("microslip: " + scene_file().string() + ':' +
                                        std::to_string(line) + ": warning: " + doubt))
      << of_file.error;
  EXPECT_NE(text_of(out() / "summary.tsv").find("#   warning = " + doubt), std::string::npos);
  const std::string tiny = "--set motion.distance=1e-11 --set step.ratio=";
  expect_warned(
      good_transient, tiny + "1e-12",
      "step.ratio = 1e-12: under a force, rounding is more than 1 % of the creepage below "
      "step.ratio = 2e-12 with 20 elements");
  EXPECT_EQ(run(good_transient, tiny + "2e-12").error, "");
  EXPECT_EQ(run(good_transient, tiny + "1e-12 --set start.force=1 --set load.force= "
                                       "--set load.creepage=0.01")
                .error,
            "");
  EXPECT_EQ(run(good_scene, standard + "--set step.ratio=0.7").error, "");
  EXPECT_EQ(run(good_transient, "--set step.ratio=0.01").error, "");
}

// A kind of warning is one line, however many values have it.
TEST_F(Warnings, OfASweepAreCounted) {
  const std::string scene = good_scene + R"(sweep {
  grid { elements "4 51" }
  step { ratio "0.1 0.2 1" }
})";
  const Outcome outcome = run_program("microslip", "sweep", scene, "--set leading_edge=standard");
  const std::string safe = "leading_edge inversion is safe for any\n";
  EXPECT_EQ(outcome.error,
            "microslip: warning: 4 of 6 cases, the first is case 1 of 6 (grid.elements = 4, "
            "step.ratio = 0.1): step.ratio = 0.1: this scheme is safe from 0.7 to 1.5; " +
                safe +
                "microslip: warning: 3 of 6 cases, the first is case 1 of 6 (grid.elements = 4, "
                "step.ratio = 0.1): grid.elements = 4: this scheme is safe from 11 on; " +
                safe);
}

// A bound that jumps: elements are a tenth wrong, and inversion is right.
TEST_F(Warnings, TellOfElementsThatDoNotResolveATable) {
  std::ofstream(scene_file().parent_path() / "jump.tsv")
      << "x\tbound\n-5\t0\n0\t300\n0.01\t30\n5\t0\n";
  const std::string contact = R"(
material { shear_modulus 82 GPa
           poisson_ratio 0.28 }
contact  { half_width 5
           bound_file jump.tsv }
kernel   { type strip
           width 10 }
grid     { elements 100 }
load     { force -801.705 }
)";
  const auto creepage = [&] { return summary_value("creepage"); };
  EXPECT_EQ(run("problem steady\n" + contact, "").error, "");
  EXPECT_NEAR(creepage(), 5.385039345e-3, 1e-11);
  const Outcome elements = run("problem steady\n" + contact, "--set leading_edge=calibrated");
  EXPECT_NE(elements.error.find("the change of the result from elements that are twice as long is"),
            std::string::npos)
      << elements.error;
  EXPECT_GT(std::abs(creepage() / 5.385039345e-3 - 1), 0.1);
  const std::string transient = "problem transient\n" + contact +
                                "step { ratio 1 }\nmotion { distance 1 }\n"
                                "start { type cattaneo }\n";
  const Outcome rolled = run(transient, "");
  EXPECT_NE(rolled.error.find("grid.elements = 100: they do not resolve the table of the bound: in "
                              "steady rolling under the largest load of the run their creepage is "
                              "off by -18 %"),
            std::string::npos)
      << rolled.error;
  EXPECT_EQ(run(transient, "--set load.force=-80").error, "");
}

}  // namespace microslip::warnings_test
