// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of input files of CONTACT, and what has none. All texts are made for these tests.
#include "microslip/scene/contact_input.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "contact_input_text.hpp"
#include "microslip/reference/point_contact.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::contact_input_test {

using std::numbers::pi;

std::string scene_text(const std::string& input, const InputImport& import = {}) {
  return scene_of_input(input, "a.inp", import).text;
}

Scene imported(const std::string& input, const InputImport& import = {}) {
  return scene_of(scene_text(input, import));
}

SteadyPatch ellipse_of(const std::string& input) {
  Scene scene = imported(input);
  return std::get<SteadyPatch>(read_model(scene));
}

std::string error_of(const std::string& input, const InputImport& import = {}) {
  try {
    scene_text(input, import);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(ContactInput, HasAnEllipseInSteadyRolling) {
  const SteadyPatch patch = ellipse_of(good_input);
  EXPECT_EQ(patch.bound.half_width(), 1);
  EXPECT_EQ(patch.bound.lateral_half_width(), 2);
  EXPECT_NEAR(patch.bound.total(), 0.3, 1e-15);
  EXPECT_EQ(patch.material.shear_modulus, 1);
  EXPECT_EQ(patch.material.poisson_ratio, 0.28);
  EXPECT_EQ(patch.load, (PatchLoad{{{false, 0.07}, {false, 0.02}, {false, -0.01}}}));
}

TEST(ContactInput, HasForcesOverFullSliding) {
  const std::string both =
      replaced(replaced(good_input, "203100", "203120"), "0.07  0.02", "-.5, 2d-1");
  const SteadyPatch patch = ellipse_of(both);
  EXPECT_TRUE(patch.load[0].by_resultant && patch.load[1].by_resultant);
  EXPECT_NEAR(patch.load[0].value, -0.15, 1e-15);
  EXPECT_NEAR(patch.load[1].value, 0.06, 1e-15);
  EXPECT_EQ(patch.load[2], (PatchComponent{false, -0.01}));
  const SteadyPatch one = ellipse_of(replaced(both, "203120", "203110"));
  EXPECT_TRUE(one.load[0].by_resultant);
  EXPECT_EQ(one.load[1], (PatchComponent{false, 0.2}));
}

// Groups may go on in the next lines, and commas, tabs and equal signs are blanks.
TEST(ContactInput, ReadsGroupsAsTheyAreWritten) {
  const std::string other =
      replaced(replaced(replaced(good_input, "  20 20  1.0", "20,\t20 =\n% no\n\n 1.D0"),
                        "0.28 0.28 1.0", "+.28\n 0.28, 10.0E-1"),
               "203100 ", "203100,");
  EXPECT_EQ(scene_text(other), scene_text(good_input));
}

// CONTACT prints a = 6.304, b = 12.61 and B1 = 0.2814e-3 for this case: examples/tractcurv.ref_out
// of its open source version, revision 2707.
TEST(ContactInput, HasHertzsEllipses) {
  std::string input = replaced(good_input, "1.0  0.07", "106700. 0.0008");
  input = replaced(input, "0.28 0.28 1.0 1.0", "0.28 0.28 82000. 82000.");
  const std::string by_ratio =
      replaced(replaced(input, "  -3 ", "  -2 "), "20 20  1.0 2.0", "48 44 0.0008 0.5");
  const SteadyPatch found = ellipse_of(by_ratio);
  EXPECT_NEAR(found.bound.half_width(), 6.304, 6e-4);
  EXPECT_NEAR(found.bound.lateral_half_width(), 12.61, 6e-3);
  EXPECT_NEAR(found.bound.ratio(), 0.5, 1e-12);
  EXPECT_NEAR(1 / imported(by_ratio).number("contact.lateral_radius_1"), 2 * 0.2814e-3, 1.1e-7);

  const std::string by_curvatures =
      replaced(replaced(input, "  -3 ", "  -1 "), "20 20  1.0 2.0", "48 44 0.0008 0.2814d-3");
  EXPECT_NEAR(ellipse_of(by_curvatures).bound.half_width(), 6.304, 6e-4);
  const struct {
    int kind;
    const char* place;  ///< of a box -7 to 7 by -14 to 14
  } boxes[] = {{1, "-7 -14 0.25 0.5"},
               {2, "-7 -14 7 14"},
               {3, "-6.875 -13.75 0.25 0.5"},
               {4, "-6.875 -13.75 6.875 13.75"}};
  for (const auto& [kind, place] : boxes) {
    const std::string box =
        replaced(replaced(input, "  -3 ", fmt::format("  {} ", kind)), "20 20  1.0 2.0 1.0",
                 fmt::format("56 56 {}\n 1 1\n 0.0008 0 0.2814d-3 0 0 0\n%", place));
    EXPECT_NEAR(ellipse_of(box).bound.lateral_half_width(), 12.61, 6e-3) << kind;
    EXPECT_EQ(error_of(box, {.direct = true}), "none");
  }
}

// The ratio of semi-axes and their size against Hertz's formulas, which take curvatures.
TEST(ContactInput, HasTheEllipseOfAnyRatio) {
  std::mt19937 random(4607);
  std::uniform_real_distribution<double> logarithm(-1, 1), poisson(0, 0.5);
  for (int i = 0; i < 200; ++i) {
    const double along = 0.01 * std::pow(10, logarithm(random));  // 2 A1
    const double ratio = std::pow(9, logarithm(random)), nu = poisson(random);
    const double load = 1e4 * std::pow(10, logarithm(random));
    std::string input = replaced(good_input, "1.0  0.07", fmt::format("{} 0.001", load));
    input = replaced(input, "0.28 0.28 1.0 1.0", fmt::format("{0} {0} 8e4 8e4", nu));
    input = replaced(input, "  -3 ", "  -2 ");
    input = replaced(input, "20 20  1.0 2.0", fmt::format("20 20 {} {}", along / 2, ratio));
    Scene scene = imported(input);
    const double across = 1 / scene.number("contact.lateral_radius_1");
    const PointContact hertz({8e4, nu}, load, along, across);
    EXPECT_NEAR(hertz.half_width() / hertz.lateral_half_width(), ratio, 1e-9 * ratio);
    EXPECT_NEAR(scene.number("contact.radius_1") * along, 1, 1e-14);
  }
}

// By an approach d, a circle of the relative radius R has a^2 = R d.
TEST(ContactInput, HasTheLoadOfAnApproach) {
  const double load = 16.0 / 3 * 1 / (1 - 0.28) * std::pow(0.6, 3) / (4 * 7.2);
  std::string input = replaced(replaced(good_input, "203100", "203000"), "1.0  0.07",
                               fmt::format("{} 0.07", 0.6 * 0.6 / 7.2));
  const std::string curved = replaced(replaced(input, "  -3 ", "  -1 "), "20 20  1.0 2.0",
                                      fmt::format("20 20 {0} {0}", 1 / 14.4));
  EXPECT_NEAR(ellipse_of(curved).bound.half_width(), 0.6, 1e-9);
  EXPECT_NEAR(ellipse_of(curved).bound.total(), 0.3 * load, 1e-9 * load);
  const std::string circle = replaced(input, "20 20  1.0 2.0", "20 20 0.6 0.6");
  EXPECT_NEAR(ellipse_of(circle).bound.total(), 0.3 * load, 1e-9 * load);
  EXPECT_EQ(scene_of_input(circle, "a.inp", {}).notes.size(), 1U);
}

TEST(ContactInput, CombinesQuasiIdenticalBodies) {
  // (1 - 2 nu)/G is the same: 0.44/1 and 0.22/0.5.
  const SteadyPatch patch =
      ellipse_of(replaced(good_input, "0.28 0.28 1.0 1.0", "0.28 0.39 1.0 0.5"));
  EXPECT_NEAR(patch.material.shear_modulus, 2.0 / 3, 1e-15);
  EXPECT_NEAR(patch.material.poisson_ratio, (0.28 + 0.78) / 3, 1e-15);
}

TEST(ContactInput, HasAStripForOneRow) {
  Scene scene = imported(good_row);
  EXPECT_EQ(scene.text("kernel.width"), "10");
  EXPECT_NEAR(scene.number("contact.normal_load"), 178.9, 1e-12);
  EXPECT_EQ(scene.text("contact.radius_1"), "500");
  EXPECT_FALSE(scene.has("direction"));
  const auto problem = std::get<SteadyProblem>(read_model(scene));
  // a^2 = 4 P R (1 - nu)/(pi G)
  const double a = std::sqrt(4 * 178.9 * 500 * 0.72 / (pi * 82000));
  EXPECT_NEAR(half_width_of(problem.contact.bound), a, 1e-12);
  EXPECT_EQ(scene.text("grid.elements"), std::to_string(std::lround(2 * a / 0.04)));

  const std::string given = replaced(
      good_row,
      "  1                          IPOTCN\n  60 1 -1.2 -5. 0.04 10.     MX, MY, XL, YL, DX, DY\n  "
      "1 1                        IBASE, IPLAN\n  0.001 0 0 0 0 0            B1 to B6\n",
      fmt::format("-5\n 60 1 {} 5. 1.2\n", a));
  Scene by_half_width = imported(given);
  EXPECT_NEAR(by_half_width.number("contact.peak_traction"), 0.3 * 2 * 178.9 / (pi * a), 1e-9);
  EXPECT_EQ(by_half_width.text("grid.elements"), "50");
  Scene by_curvature = imported(replaced(given, fmt::format("-5\n 60 1 {}", a), "-4\n 60 1 0.001"));
  EXPECT_EQ(by_curvature.text("contact.radius_1"), "500");
  EXPECT_EQ(by_curvature.text("kernel.width"), "10");
}

TEST(ContactInput, LoadsARowAcross) {
  const std::string across = replaced(good_row, "0.001 0. 0. ", "0. -0.002 0. ");
  Scene scene = imported(across);
  EXPECT_EQ(scene.text("direction"), "lateral");
  EXPECT_EQ(scene.number("load.creepage"), -0.002);
  EXPECT_EQ(error_of(replaced(good_row, "0.001 0. 0. ", "0.001 0.1 0. ")),
            "a.inp:7: CKSI = 0.001: expected 0 with one row of elements that is loaded across");
}

TEST(ContactInput, TurnsRollingBackwards) {
  const std::string back = replaced(good_input, "  0.0  0.1", "  180.d  0.1");
  EXPECT_EQ(ellipse_of(back).load, (PatchLoad{{{false, -0.07}, {false, -0.02}, {false, -0.01}}}));
  const ImportedScene scene = scene_of_input(back, "a.inp", {});
  ASSERT_EQ(scene.notes.size(), 1U);
  EXPECT_NE(scene.notes[0].find("opposite"), std::string::npos);
  EXPECT_NE(scene.text.find("; " + scene.notes[0]), std::string::npos);
  EXPECT_EQ(scene_text(replaced(good_input, "  0.0  0.1", "  360d  0.1")), scene_text(good_input));
}

TEST(ContactInput, TakesADirectionInFewDigits) {
  const std::string few = replaced(good_input, "  0.0  0.1", "  3.14  0.1");
  EXPECT_EQ(ellipse_of(few).load, (PatchLoad{{{false, -0.07}, {false, -0.02}, {false, -0.01}}}));
  const ImportedScene scene = scene_of_input(few, "a.inp", {});
  ASSERT_EQ(scene.notes.size(), 2U);
  EXPECT_NE(scene.notes[0].find("CHI = 3.14: taken as 180d, rolling along x"), std::string::npos)
      << scene.notes[0];
}

TEST(ContactInput, MakesARunOfStepsThatContinue) {
  Scene scene = imported(good_run, {.number = 4});
  const auto run = std::get<PatchTransient>(read_model(scene));
  ASSERT_EQ(run.shifts.size(), 1U);
  EXPECT_NEAR(run.shifts[0][0].value, 0.3 * 0.07, 1e-15);
  EXPECT_TRUE(run.shifts[0][0].by_resultant);
  EXPECT_EQ(run.shifts[0][1], (PatchComponent{false, 0.02}));
  EXPECT_EQ(run.shifts[0][2], (PatchComponent{false, -0.01}));
  EXPECT_NEAR(run.loads.at(0)[0].value, 0.3 * 0.07, 1e-15);
  EXPECT_NEAR(run.distance, 0.3, 1e-15);
  EXPECT_NEAR(run.step_lengths()[0], 0.1, 1e-15);
  EXPECT_TRUE(std::holds_alternative<Remembered>(run.scheme));
  Scene first = imported(good_run, {.number = 1});
  EXPECT_EQ(std::get<PatchTransient>(read_model(first)).shifts.size(), 1U);
}

TEST(ContactInput, BeginsARunAnewAtRest) {
  for (const char* digits : {"202110", "102110"}) {
    std::string input = good_run;
    input = replaced(input, "3 MODULE\n 002110\n 100000",
                     fmt::format("3 MODULE\n {}\n 100000", digits));
    Scene scene = imported(input, {.number = 4});
    const auto run = std::get<PatchTransient>(read_model(scene));
    EXPECT_TRUE(run.shifts.empty());
    EXPECT_NEAR(run.distance, 0.2, 1e-15) << digits;
  }
}

TEST(ContactInput, HasSeveralShifts) {
  const std::string second = R"( 3 MODULE
 001110
 100000
 0101541
  1.0  -0.5  0.02  0
)";
  const std::string input =
      replaced(good_run, " 3 MODULE\n 002110\n 102000", second + " 3 MODULE\n 002110\n 102000");
  Scene scene = imported(input, {.number = 2});
  const auto run = std::get<PatchTransient>(read_model(scene));
  ASSERT_EQ(run.shifts.size(), 2U);
  EXPECT_NEAR(run.shifts[1][0].value, -0.15, 1e-15);
  EXPECT_EQ(run.shifts[1][2].value, 0);
  EXPECT_EQ(error_of(replaced(input, " 001110\n", " 001100\n"), {.number = 2}),
            "a.inp:13: F (FORCE) = 0: expected 1, as in the shift before");
}

TEST(ContactInput, RefusesRunsThatNoSceneSays) {
  const struct {
    const char *from, *to, *error;
  } cases[] = {
      {"100000\n 0101541\n  1.0  0.07", "100000\n 0101541\n  1.1  0.07",
       "a.inp:23: FN = 1.1: expected 1.0 as before, or D = 2, a new potential contact"},
      {"100000\n 0101541\n  1.0  0.07  0.02  -0.01",
       "000000\n 0101541\n  1.0  0.07  0.02  -0.01\n 0.4 0.4",
       "a.inp:20: case 3 continues case 2 with another contact: expected the same load, friction, "
       "bodies and curvatures, or P = 2, a start at rest"},
      {"100000\n 0101541\n  1.0  0.07", "100000\n 0101541\n  1.0  0.08",
       "a.inp:23: FX = 0.08: expected 0.07 as in the step before: a scene has one load over all "
       "steps"},
      {"100000\n 0101541\n  1.0  0.07  0.02", "100000\n 0101541\n  1.0  0.07  0.03",
       "a.inp:23: CETA = 0.03: expected 0.02 as in the step before"},
      {"002110\n 100000", "002100\n 100000",
       "a.inp:20: F (FORCE) = 0: expected 1, as in the case that it continues"},
      {"002110\n 100000", "001110\n 100000",
       "a.inp:20: T (TANG) = 1: expected 2 behind a step of rolling, or P = 2, a start at rest"},
      {"002110\n 100000", "302110\n 100000",
       "a.inp:20: P (PVTIME) = 3: expected 0, 1 or 2 for a shift or a step"},
      {"002110\n 100000", "003110\n 100000",
       "a.inp:25: P (PVTIME) = 0: expected 2, a start at rest, behind steady rolling"},
      {"002110\n 100000", "002110\n 102000\n 0101541\n 1. .07 .02 -.01\n 0 0.2 1.\n .28 .28 1 1\n%",
       "a.inp:24: DQ = 0.2: expected 0.1 as in the step before"},
      {"002110\n 100000",
       "002110\n 102000\n 0101541\n 1. .07 .02 -.01\n 180d 0.1 1.\n .28 .28 1 1\n%",
       "a.inp:24: CHI = 180d: expected 0.0 as in the step before"}};
  for (const auto& [from, to, error] : cases) {
    std::string input = replaced(good_run, from, to);
    if (std::string(to).find('%') != std::string::npos) {  // lines behind it are of the case before
      input = replaced(input, "%\n 0101541\n  1.0  0.07  0.02  -0.01\n", "");
    }
    EXPECT_EQ(error_of(input, {.number = 4}).find(error), 0U)
        << error_of(input, {.number = 4}) << "\n"
        << error;
  }
}

TEST(ContactInput, HasContactsSchemeAndElements) {
  Scene steady = imported(good_input, {.direct = true});
  const auto rolled = std::get<PatchTransient>(read_model(steady));
  EXPECT_TRUE(std::holds_alternative<Direct>(rolled.scheme));
  EXPECT_EQ(rolled.patch.elements, 20);
  EXPECT_EQ(rolled.patch.rows, 20);
  EXPECT_EQ(rolled.step_ratios, std::vector<double>{1});
  EXPECT_TRUE(rolled.shifts.empty());
  const std::string around = replaced(good_input, "20 20  1.0 2.0 1.0", "24 24 1.0 2.0 1.2");
  EXPECT_EQ(scene_text(around, {.direct = true}), scene_text(good_input, {.direct = true}));
  EXPECT_TRUE(scene_of_input(around, "a.inp", {.direct = true}).notes.empty());
  for (const char* other : {"23 23 1.0 2.0 1.2", "24 24 1.0 2.0 1.25", "21 20 1.0 2.0 1.05"}) {
    const std::string input = replaced(good_input, "20 20  1.0 2.0 1.0", other);
    EXPECT_EQ(scene_of_input(input, "a.inp", {.direct = true}).notes.size(), 1U) << other;
  }
  Scene row = imported(good_row, {.direct = true});
  EXPECT_EQ(row.text("leading_edge"), "standard");
}

TEST(ContactInput, ChoosesACase) {
  EXPECT_EQ(error_of(good_run),
            "a.inp has 4 cases: expected --case and one of 1 to 4; --list describes them");
  EXPECT_EQ(error_of(good_run, {.number = 5}), "--case 5: expected a case of a.inp, 1 to 4");
  EXPECT_EQ(error_of("% nothing\n" + good_end), "a.inp: it has no case");
  const std::string behind = good_case + " 1 MODULE\n whatever\n";
  EXPECT_EQ(scene_text(behind, {.number = 1}), scene_text(good_case + good_end));
  EXPECT_NE(error_of(behind).find("a.inp:12: MODULE = 1: expected 3"), std::string::npos);
}

TEST(ContactInput, ListsAllCases) {
  const InputList list =
      cases_of_input(replaced(good_run, "002110\n 100000", "002110\n 100100"), "a.inp", false);
  const std::vector<std::string> expected{
      "case 1: a shift of an ellipse", "case 2: a shift and a step of an ellipse",
      "case 3: a.inp:21: M (MATER) = 1: expected 0, elastic bodies",
      "case 4: a.inp:21: M (MATER) = 1: expected 0, elastic bodies"};
  EXPECT_EQ(list.lines, expected);
  EXPECT_EQ(list.error, "");
  const InputList broken = cases_of_input(good_case + " 3 MODULE\n x\n", "a.inp", false);
  EXPECT_EQ(broken.lines, std::vector<std::string>{"case 1: steady rolling of an ellipse"});
  EXPECT_EQ(broken.error, "a.inp:13: PBTNFS = x: expected a whole number");
}

TEST(ContactInput, KeepsContactPatchesApart) {
  const std::string other =
      replaced(replaced(good_case, " 3  MODULE", " 3 1 2 PATCH"), "0.07", "0.01");
  const std::string third = R"( 3 1 1 PATCH
 203100
 100000
 0101541
  1.0  0.03  0.02  -0.01
)";
  const std::string first = replaced(good_case, " 3  MODULE", " 3 1 1 PATCH");
  Scene scene = imported(
      first + replaced(other, "20 20  1.0 2.0", "20 20 1.0 3.0") + third + good_end, {.number = 3});
  EXPECT_EQ(scene.number("contact.lateral_half_width"), 2);
  EXPECT_EQ(scene.number("load.creepage"), 0.03);
}

/// A case in which texts are replaced.
struct Form {
  const char* what;
  std::vector<std::pair<std::string, std::string>> changes;
};

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

const std::string solver = "0000541   H-G-I-A-O-W-R\n  999 100 30 1 1d-6 ";
const std::string size = "  20 20  1.0 2.0 1.0         MX, MY, AA, BB, SCALE\n";
const std::string friction = "  0.3  0.3                   FSTAT, FKIN\n";

// Cases without a scene are read to their end: what follows them is found.
TEST(ContactInput, PassesOverAllFormsOfModule3) {
  const std::pair<std::string, std::string> one{"  -3 ", " 1\n -3 "};
  const std::pair<std::string, std::string> three{"  -3 ", " 1 2 3\n -3 "};
  const std::pair<std::string, std::string> four{"  -3 ", " 1 2 3 4\n -3 "};
  const std::vector<Form> forms{
      {"as it is", {}},
      {"X = 1", {{"0000541", "10000541\n 1000005 2"}}},
      {"G = 1", {{solver, "0100541\n%"}}},
      {"G = 2", {{solver, "0200541\n 9 9 9 1 1e-6\n 1 1 1 1.\n%"}}},
      {"G = 4", {{solver, "0400541\n 9 9 9 1 1e-6\n 1 1.\n%"}}},
      {"G = 5", {{solver, "0500541\n 9 9 9 1 1e-6\n 1 1 1 1 1 1 1\n 1\n%"}}},
      {"L = 2", {{"022020", "222020"}, {friction, " .1 .2 1 0\n 1\n 0.003 1.\n"}}},
      {"L = 4", {{"022020", "422020"}, {friction, " .1 .2 1 0 1\n 0.003 1.\n"}}},
      {"L = 6", {{"022020", "622020"}, {friction, " 1 2 3 4\n 5 6\n"}}},
      {"V = 3", {{"022020", "3022020"}, {friction, ""}, {size, size + repeated(friction, 20)}}},
      {"M2 = 2", {{"022020 ", "022020 2 "}, four}},
      {"E = 9", {{"022020", "022029"}, {size, size + repeated(" 1 2\n", 400)}}},
      {"C = 4", {{"022020", "024020"}, {"0.28 0.28", "1 1 2\n 1. 2d 3. 4d\n 0.28 0.28"}}},
      {"C = 9", {{"022020", "029020"}, {"0.28 0.28", "'a.txt'\n 0.28 0.28"}}},
      {"M = 1", {{"022020", "022120"}, four}},
      {"M = 2", {{"022020", "022220"}, four}},
      {"M = 3", {{"022020", "022320"}, three}},
      {"M = 4", {{"022020", "022420"}, four}},
      {"M = 5", {{"022020", "022520"}, three}},
      {"M = 6", {{"022020", "022620"}}},
      {"B = 1", {{"203100", "213100"}, one}},
      {"T = 0", {{"203100", "200100"}, {"  0.0  0.1  1000.            CHI, DQ, VELOC\n", ""}}},
      {"H = 3", {{"0000541", "3000541"}, {"  -3 ", " 1 2 3 4\n 1 2 3 4\n -3 "}}},
      {"H = 3, M = 4",
       {{"0000541", "3000541"},
        {"022020", "022420"},
        {"  -3 ", " 1 2 3 4\n 1 2 3 4\n 1 2 3 4\n 1\n -3 "}}},
      {"S = 2", {{"203100", "203102"}, {size, size + "0 1\n"}}},
      {"S = 3",
       {{"203100", "203103"},
        {size, size + "0 1\n 1\n 5 0 0.1\n 2\n 1 1 9\n 1 1 9\n 3 0 1.\n 3\n 2 1\n 1 2\n 3\n"
                      "5 0. 1.\n 5\n 2\n 0 1\n 6\n 1 1 9\n 1 1 9\n 2\n 0 1\n 7\n 1 1\n 1\n 1\n 3\n"
                      "0 1\n 2\n 9\n 1 2 3\n 1\n 1 2\n 1 2\n 3\n 0\n"}}},
      {"IPOTCN = -6", {{"  -3 ", "  -6 "}, {size, " 20 20 1 1 1 1\n"}}},
      {"IBASE = 2, IPLAN = 4",
       {{"  -3 ", "  1 "},
        {size, " 9 9 -1 -1 .1 .1\n 2 4\n 3 0 9 0 1\n 1 2 3\n 2\n 1 2 3 4 5 6 7 8\n 0.5\n"}}},
      {"IBASE = 3, IPLAN = 2",
       {{"  -3 ", "  2 "}, {size, " 9 9 -1 -1 1 1\n 3 2\n 1 2 3 4 5 6 7 8\n 1 2 3 4 5 6\n"}}},
      {"IBASE = 9, IPLAN = 3",
       {{"  -3 ", "  3 "},
        {size, " 9 9 -1 -1 .1 .1\n 9 3\n" + repeated(" 1", 80) + "\n 1\n 1 2 3 4 5 6 7 8\n"}}}};
  // Without damping, which otherwise stays.
  const std::string last = replaced(good_case, "022020 ", "022020 0 ") + good_end;
  for (const Form& form : forms) {
    std::string input = good_case;
    for (const auto& [from, to] : form.changes) input = replaced(input, from, to);
    EXPECT_EQ(error_of(input + last, {.number = 2}), "none") << form.what;
    const InputList list = cases_of_input(input + last, "a.inp", false);
    EXPECT_EQ(list.error, "") << form.what;
    EXPECT_EQ(list.lines.size(), 2U) << form.what;
    EXPECT_EQ(list.lines.back(), "case 2: steady rolling of an ellipse") << form.what;
  }
}

}  // namespace microslip::contact_input_test
