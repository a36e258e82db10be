// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that tell users of other programs, and of three dimensions, what they may have meant.
#include <fstream>
#include <string>

#include "robustness/bad_scenes.hpp"

namespace microslip::words_test {

class Words : public BadScenes {};

TEST_F(Words, TellWhatMakesAnEllipse) {
  expect_rejected(good_scene, "--set load.spin=1",
                  "key 'load.spin' has no role here: it is for ellipses; "
                  "contact.lateral_half_width or contact.lateral_radius_1 or "
                  "contact.lateral_radius_2 or contact.patch_file makes the contact one");
  expect_rejected(good_scene, "--set load.creepage_y=1",
                  "load.creepage_y': three-dimensional: an ellipse has contact.lateral_half_width");
}

TEST_F(Words, KnowInputFilesOfContact) {
  const Outcome outcome = run(" 3 MODULE\n 1 1  RESULT ELEMENT, CONTACT PATCH\n", "");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("found an input file of CONTACT"), std::string::npos)
      << outcome.error;
}

TEST_F(Words, AskForLoadsPerWidth) {
  expect_rejected(good_scene,
                  "--set contact.peak_traction= --set contact.half_width= "
                  "--set contact.radius_1=460 --set contact.friction=0.3 "
                  "--set contact.normal_load='80 kN'",
                  "contact.normal_load = '80 kN': expected a number in N/mm or another of its kind "
                  "(N/m, kN/m), per mm of width: divide by the width");
}

// A unit behind the last number holds for the whole list.
TEST_F(Words, TakePercentForLists) {
  EXPECT_EQ(run(good_transient, "--set step.ratio='100 50 %'").error, "");
  const std::string by_percent = text_of(out() / "history.tsv");
  EXPECT_EQ(run(good_transient, "--set step.ratio='1 0.5'").error, "");
  const auto rows = [](const std::string& text) { return text.substr(text.find("\nq")); };
  EXPECT_EQ(rows(by_percent), rows(text_of(out() / "history.tsv")));
}

TEST_F(Words, SayWhatCameOut) {
  EXPECT_EQ(run(good_scene, "").output.find("microslip: force "), 0U);
  EXPECT_EQ(run(good_scene, "--quiet").output, "");
}

}  // namespace microslip::words_test
