// SPDX-License-Identifier: GPL-3.0-or-later
// A case of an input file of CONTACT without a scene is refused in one line, with file, line, name,
// value and what is accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "contact_input_text.hpp"
#include "microslip/scene/contact_input.hpp"

namespace microslip::contact_input_refusals_test {

std::string refusal_of(const std::string& input, const InputImport& import = {}) {
  try {
    scene_of_input(input, "a.inp", import);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

struct Refusal {
  std::string from, to;
  std::string error;  ///< its beginning, behind the name of the file
};

void expect_refusals(const std::string& good, const std::vector<Refusal>& refusals,
                     const InputImport& import = {}) {
  EXPECT_EQ(refusal_of(good, import), "none");
  for (const auto& [from, to, error] : refusals) {
    const std::string found = refusal_of(replaced(good, from, to), import);
    EXPECT_EQ(found.find("a.inp:" + error), 0U) << found << "\n" << error;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
}

TEST(ContactInputRefusals, NameControlDigits) {
  expect_refusals(
      good_input,
      {{" 3  MODULE", " 1  MODULE", "2: MODULE = 1: expected 3, the basic contact, or 0"},
       {" 3  MODULE", " 2  MODULE", "2: MODULE = 2: expected 3"},
       {"203100", "233100", "3: B (BOUND) = 3: expected 0 or 2, Hertz's contact"},
       {"203100", "243100", "3: B (BOUND) = 4: expected 0 or 2"},
       {"203100", "253100", "3: B (BOUND) = 5: expected 0 or 2"},
       {"203100", "263100", "3: B (BOUND) = 6: expected 0 or 2"},
       {"203100", "204100", "3: T (TANG) = 4: expected 1, a shift, 2, a step"},
       {"203100", "203200", "3: N (NORM) = 2: expected 0 or 1"},
       {"203100", "203130", "3: F (FORCE) = 3: expected 0, 1 or 2"},
       {"203100", "203104", "3: S (STRESS) = 4: expected 0 to 3"},
       {"203100", "1203100", "3: control digits PBTNFS = 1203100: expected a number of at most 6"},
       {"203100", "-3100", "3: control digits PBTNFS = -3100: expected"},
       {"022020", "1022020", "4: V (VARFRC) = 1: expected 0, one friction coefficient"},
       {"022020", "122020", "4: L (FRCLAW) = 1: expected 0"},
       {"022020", "522020", "4: L (FRCLAW) = 5: expected 0, Coulomb's friction"},
       {"022020", "002020", "4: D (DISCNS) = 0: expected 2 in the first case"},
       {"022020", "032020", "4: D (DISCNS) = 3: expected 0, 1 or 2"},
       {"022020", "020020", "4: C (INFLCF) = 0: expected 2 or 3"},
       {"022020", "025020", "4: C (INFLCF) = 5: expected 2 or 3, elastic half-spaces"},
       {"022020", "022620", "4: M (MATER) = 6: expected 0, elastic bodies"},
       {"022020", "022820", "4: M (MATER) = 8: expected 0, elastic bodies"},
       {"022020", "022030", "4: Z (RZNORM) = 3: expected 0, 1 or 2"},
       {"022020", "022022", "4: E (EXRHS) = 2: expected 0, no extra term"},
       {"022020 ", "022020 11 ", "4: the digit before M2 = 1: expected 0"},
       {"022020 ", "022020 3 ", "4: M2 = 3: expected 0, 1 or 2"},
       {"0000541", "2000541", "5: H (HEAT) = 2: expected 0, 1 or 3"},
       {"0000541", "0600541", "5: G (GAUSEI) = 6: expected 0 to 5"},
       {"0000541", "0000543", "5: R (RETURN) = 3: expected 0 or 1; CONTACT does not compute"},
       {"0000541", "0000544", "5: R (RETURN) = 4: expected 0 to 3"}});
  expect_refusals(good_input,
                  {{"203100", "223100", "3: B (BOUND) = 2: expected 0 with --scheme direct"},
                   {"022020", "023020", "4: C (INFLCF) = 3: expected 2 with --scheme direct"},
                   {"1000. ", "1000. 0.5 ", "9: FACPHI = 0.5: expected 1/6 with --scheme direct"},
                   {"20 20 ", "210 20 ", "3: case 1 has no scene: "}},
                  {.direct = true});
}

TEST(ContactInputRefusals, NameDigitsThatKeepWhatWasBefore) {
  const std::string next = " 3 MODULE\n 203100\n 100000\n 0101541\n 1.0 0.05 0 0\n";
  const std::string two = "% a file\n" + good_case + next + good_end;
  EXPECT_EQ(refusal_of(two, {.number = 2}), "none");
  const std::string conformal =
      replaced(replaced(two, "022020", "024020"), "0.28 0.28", "1 1 1\n 1. 2d\n 0.28 0.28");
  EXPECT_EQ(refusal_of(conformal, {.number = 2}),
            "a.inp:4: C (INFLCF) = 4: expected 2 or 3, elastic half-spaces");
  // The box and the curvatures of semi-axes stay with D = 0, and so must what made them.
  expect_refusals(two,
                  {{" 1.0 0.05 0 0", " 2.0 0.05 0 0",
                    "17: FN = 2.0: expected 1.0 as before, or D = 2, a new potential contact"},
                   {" 100000\n 0101541\n 1.0 0.05 0 0",
                    " 102000\n 0101541\n 1.0 0.05 0 0\n 0 0.1 1\n 0.28 0.28 2 2",
                    "19: GG1 = 2: expected 1.0 as before"},
                   {"203100\n 100000", "203000\n 100000", "17: PEN = 1.0: expected 1.0 as before"}},
                  {.number = 2});
  EXPECT_EQ(refusal_of(
                replaced(replaced(two, " 1.0 0.05 0 0\n", " 2.0 0.05 0 0\n"), " 100000", " 110010"),
                {.number = 2}),
            "none");
  const std::string falling =
      replaced(replaced(two, "022020", "422020"), "0.3  0.3 ", ".1 .2 1 0 1\n .003 1 %");
  EXPECT_EQ(refusal_of(falling, {.number = 2}),
            "a.inp:4: L (FRCLAW) = 4: expected 0, Coulomb's friction with FSTAT = FKIN");
  std::string terms;
  for (int i = 0; i < 400; ++i) terms += " 0 1\n";
  const std::string extra =
      replaced(replaced(replaced(two, "022020", "022029"), " 100000", " 100001"),
               " 3 MODULE\n 203100", terms + " 3 MODULE\n 203100");
  EXPECT_EQ(refusal_of(extra, {.number = 2}),
            "a.inp:4: E (EXRHS) = 9: expected 0, no extra term of the rigid slip");
  const std::string damped =
      replaced(replaced(two, "022020 ", "022020 2 "), "  -3 ", " 1 2 3 4\n -3 ");
  EXPECT_EQ(refusal_of(damped, {.number = 2}), "a.inp:4: M2 = 2: expected 0, without damping");
}

TEST(ContactInputRefusals, NameNumbers) {
  expect_refusals(
      good_input,
      {{"  1.0  0.07", "  0.0  0.07", "7: FN = 0.0: expected a number > 0"},
       {"  1.0  0.07", "  -1  0.07", "7: FN = -1: expected a number > 0"},
       {"  1.0  0.07", "  1.0  x", "7: CKSI = x: expected a number"},
       {"  1.0  0.07", "  1.0  1e999", "7: CKSI = 1e999: expected a number"},
       {"  1.0  0.07", "  nan  0.07", "7: FN = nan: expected a number"},
       {"-0.01 ", "-0.01 0.1 0 ", "7: SPINXO = 0.1: expected 0: spin about x = y = 0"},
       {"-0.01 ", "-0.01 0 0.1 ", "7: SPINYO = 0.1: expected 0: spin about x = y = 0"},
       {"0.3  0.3", "0.3  0.2", "8: FKIN = 0.2: expected FSTAT, 0.3"},
       {"0.3  0.3", "0  0.2", "8: FSTAT = 0: expected a number > 0"},
       {"  0.0  0.1", "  90d  0.1", "9: CHI = 90d: expected 0 or 180d"},
       {"  0.0  0.1", "  3.13  0.1", "9: CHI = 3.13: expected 0 or 180d"},
       {"  0.0  0.1", "  d  0.1", "9: CHI = d: expected a number"},
       {"  0.0  0.1", "  0.0  -0.1", "9: DQ = -0.1: expected a number > 0"},
       {"0.28 0.28 1.0 1.0", "0.28 0.6 1.0 1.0", "10: POISS2 = 0.6: expected a number from 0"},
       {"0.28 0.28 1.0 1.0", "0.28 0.28 1.0 0", "10: GG2 = 0: expected a number > 0"},
       {"0.28 0.28 1.0 1.0", "0.31 0.28 23e3 82e3",
        "10: K of POISS and GG = 0.1: expected quasi-identical bodies"},
       {"  -3 ", "  0 ", "11: IPOTCN = 0: expected -1 to -5, Hertz's contact, or 1 to 4"},
       {"  -3 ", "  -7 ", "11: IPOTCN = -7: expected"},
       {"  -3 ", "  -3. ", "11: IPOTCN = -3.: expected a whole number"},
       {"1.0 2.0 1.0", "0 2.0 1.0", "12: AA = 0: expected a number > 0"},
       {"1.0 2.0 1.0", "1.0 -2 1.0", "12: BB = -2: expected a number > 0"},
       {"1.0 2.0 1.0", "1.0 2.0 0.9", "12: SCALE = 0.9: expected 1 or more"},
       {"1.0 2.0 1.0", "1.0 2.0 9", "12: MX = 20: expected 3 or more elements"},
       {"20 20  1.0", "0 20  1.0", "12: MX = 0: expected a whole number > 0"},
       {"20 20  1.0", "20 1  1.0", "12: MY = 1: expected 3 or more elements"},
       {"20 20  1.0", "20 2e1  1.0", "12: MY = 2e1: expected a whole number"},
       {"20 20  1.0 2.0", "20 20  1.0 0.01", "3: case 1 has no scene: scene:"},
       {"20 20  1.0 2.0", "20 20  1e300 1e300", "3: case 1 has no scene: scene:"}});
}

TEST(ContactInputRefusals, NameForcesBeyondFriction) {
  const std::string by_forces =
      replaced(replaced(good_input, "203100", "203120"), "0.07  0.02", "-0.6  0.5");
  expect_refusals(by_forces,
                  {{"-0.6  0.5", "-1  0.0", "7: FX = -1: expected a force below full sliding"},
                   {"-0.6  0.5", "-0.6  0.8", "7: FY = 0.8: expected a force below full sliding"}});
}

TEST(ContactInputRefusals, NameGeometry) {
  const std::string geometry =
      "  1 1                        IBASE, IPLAN\n  0.001 0 0 0 0 0            B1 to B6\n";
  expect_refusals(
      good_row,
      {{geometry, " 2 1\n 2 0 9 0 1\n 3 3\n", "13: IBASE = 2: expected 1, a quadratic distance"},
       {"  1 1   ", "  4 1   ", "13: IBASE = 4: expected 1, a quadratic distance"},
       {geometry, " 3 1\n 1 2 3 4 5 6 7 8\n", "13: IBASE = 3: expected"},
       {geometry, " 1 2\n 1 0 0 0 0 0\n 1 2 3 4 5 6\n",
        "13: IPLAN = 2: expected 1, without a planform"},
       {"  1 1   ", "  1 5   ", "13: IPLAN = 5: expected 1, without a planform"},
       {"0.001 0 0 0 0 0 ", "0.001 0.1 0 0 0 0 ", "14: B2 = 0.1: expected 0"},
       {"0.001 0 0 0 0 0 ", "0.001 0 0.1 0 0 0 ", "14: B3 = 0.1: expected 0 with one row"},
       {"0.001 0 0 0 0 0 ", "0.001 0 0 1d-3 0 0 ", "14: B4 = 1d-3: expected 0"},
       {"0.001 0 0 0 0 0 ", "0.001 0 0 0 -1 0 ", "14: B5 = -1: expected 0"},
       {"0.001 0 0 0 0 0 ", "0.001 0 0 0 0 2 ", "14: B6 = 2: expected 0"},
       {"0.001 0 0 0 0 0 ", "-0.001 0 0 0 0 0 ", "14: B1 = -0.001: expected a number > 0"},
       {"0.001 0 0 0 0 0 ", "0.00067 0 0 0 0 0 ", "12: XL or XC1 = -1.2: expected a potential"},
       {"60 1 -1.2", "40 1 -1.2", "12: XL or XC1 = -1.2: expected a potential contact around"},
       {"60 1 -1.2", "60 2 -1.2", "14: B3 = 0: expected a number > 0: an ellipse, or MY = 1"},
       {"0.04 10. ", "-0.04 10. ", "12: DX = -0.04: expected a number > 0"},
       {"022020", "022000", "4: Z (RZNORM) = 0: expected 1 or 2 with a new potential contact"},
       {"203100", "223100", "3: B (BOUND) = 2: expected 0 with a potential contact"},
       {"022020", "023020", "4: C (INFLCF) = 3: expected 2 for one row of elements"},
       {"-5. 0.04 10. ", "-5. 0.04 8. ", "12: DY = 8.: expected a width of 8.9 mm or more"},
       {"203100", "203000", "3: N (NORM) = 0: expected 1, FN, for one row"},
       {"0.001 0. 0. ", "0.001 0. 1e-4 ", "7: CPHI = 1e-4: expected 0 with one row"},
       {"0.001 0. 0. ", "0.001 0.1 0. ", "7: CKSI = 0.001: expected 0 with one row"}});
}

// A file that ends early names the line and what is missing there.
TEST(ContactInputRefusals, TellWhereAFileEnds) {
  for (std::size_t size = 0; size + 11 < good_input.size(); ++size) {
    const std::string found = refusal_of(good_input.substr(0, size));
    EXPECT_EQ(found.find("a.inp"), 0U) << size << ": " << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
  EXPECT_EQ(refusal_of(good_input.substr(0, good_input.find("  0.3  0.3"))),
            "a.inp:7: the file ends here, expected FSTAT");
  EXPECT_EQ(refusal_of("% a file\n" + good_case), "a.inp:12: the file ends here, expected MODULE");
  EXPECT_EQ(refusal_of("% a file\n" + good_case, {.number = 1}),
            "a.inp:12: the file ends here, expected MODULE");
}

// Any words give a scene or one line.
TEST(ContactInputRefusals, TakeAnyText) {
  const std::vector<std::string> words{
      "0",   "1",      "3",        "-1",     "-3",          "203100", "022020", "1e308",
      "x",   "'a'",    "180d",     "1e-308", "99999999999", "%",      "\n",     "\t",
      "0.3", "MODULE", "\x01\xff", "1d-6",   "2000000000",  "-0",     "20",     "\n\n"};
  std::mt19937 random(46);
  const auto one_of = [&](std::size_t count) { return random() % count; };
  for (int i = 0; i < 3000; ++i) {
    std::string input = i % 2 == 0 ? good_input : good_row;
    for (std::size_t change = 0; change <= one_of(4); ++change) {
      const std::size_t from = one_of(input.size());
      const std::size_t to = std::min(input.size(), from + one_of(8));
      input = input.substr(0, from) + " " + words[one_of(words.size())] + " " + input.substr(to);
    }
    const std::string found = refusal_of(input, {.number = 0, .direct = i % 3 == 0});
    EXPECT_EQ(found.find_first_of("\n\x01\xff"), std::string::npos) << input << found;
    cases_of_input(input, "a.inp", false);
  }
}

}  // namespace microslip::contact_input_refusals_test
