// SPDX-License-Identifier: GPL-3.0-or-later
// The command import: scenes of input files of CONTACT, solved, against CONTACT's results; and what
// it refuses. The texts are made for these tests; where they describe an example that comes with
// CONTACT, its results are those of examples/*.ref_out in the repository of the open source
// version, github.com/eve70a/CONTACT, revision 2707 of 2025-07-23.
#include <fmt/core.h>

#include <algorithm>
#include <fstream>

#include "contact_input_text.hpp"
#include "robustness/executables.hpp"

namespace microslip::contact_inputs_test {

/// The first digits and the numbers of a case.
struct Words {
  std::string first = "203100";
  std::string kinematics = "", bodies = "";
  std::string rolling = "";  ///< none in a shift
  std::string place = "";
};

/// A case of its own contact.
std::string case_of(const Words& words, const std::string& friction) {
  return fmt::format(
      "3 MODULE\n {}\n 022020\n 0000541\n 999 100 30 1 1e-8\n {}\n {} {}\n {}{}\n {}\n",
      words.first, words.kinematics, friction, friction,
      words.rolling.empty() ? "" : words.rolling + "\n ", words.bodies, words.place);
}

class ContactInputs : public Executables {
 protected:
  void write(const std::string& input) const { std::ofstream(folder_ / "case.inp") << input; }

  /// Imports and solves a case.
  void solve(const std::string& input, const std::string& options = "") const {
    write(input);
    fs::remove(folder_ / "a scene.info");
    const Outcome imported = run_in_folder("import case.inp --to 'a scene.info' " + options);
    ASSERT_EQ(imported.status, 0) << imported.error;
    EXPECT_EQ(imported.output, "wrote a scene.info; solve it with: microslip 'a scene.info'\n");
    const Outcome solved = run_in_folder("'a scene.info' --quiet --out out");
    ASSERT_EQ(solved.status, 0) << solved.error;
  }

  /// A value of the last row of shifts.tsv.
  double of_shift(const std::string& column) const {
    std::ifstream in(out() / "shifts.tsv");
    std::vector<std::string> names, values;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with('#')) continue;
      std::vector<std::string>& cells = names.empty() ? names : values;
      cells.clear();
      std::istringstream words(line);
      for (std::string cell; words >> cell;) cells.push_back(cell);
    }
    const auto at = std::ranges::find(names, column) - names.begin();
    return std::stod(values.at(static_cast<std::size_t>(at)));
  }

  void expect_refused(const std::string& words, const std::string& error) const {
    const auto files = [&] {
      return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    };
    run_in_folder("--version");  // makes the files of its output
    const auto before = files();
    const Outcome outcome = run_in_folder("import " + words);
    EXPECT_EQ(outcome.status, 1) << words;
    EXPECT_EQ(outcome.error, "microslip: " + error + "\n") << words;
    EXPECT_EQ(outcome.output, "") << words;
    EXPECT_EQ(files(), before) << words;
  }
};

// CONTACT v25.2 with the solver GDsteady to 1e-8, run for this project: Fx, Fy, Mz and the elements
// that slip and that touch. By its scheme the ellipse rolls 24 half-widths from rest, to 1e-8 of
// the steady state.
TEST_F(ContactInputs, HaveContactsResultsByItsScheme) {
  const struct {
    const char *kinematics, *place;
    double force, lateral, moment, slipping, touching;
  } cases[] = {
      {"1. 0.07 0. 0.", "-3\n 20 20 1. 1. 1.", -0.219412088914, 0, 0, 156, 316},
      {"1. 0. 0.16 0.", "-3\n 24 24 1. 1. 1.2", 0, -0.295370719521, 0.00925296066399, 286, 316},
      {"1. 0. 0. 0.1", "-3\n 30 30 1. 1. 1.5", 0, -0.135327089913, -0.081695236678, 148, 316},
      {"1. 0.11 0. 0.", "-3\n 20 20 1. 0.5 1.0", -0.214236930376, 0, 0, 156, 320}};
  for (const auto& one : cases) {
    solve(case_of({.kinematics = one.kinematics,
                   .bodies = "0.28 0.28 1. 1.",
                   .rolling = "0. 0.1 1000.",
                   .place = one.place},
                  "0.3") +
              "0 MODULE\n",
          "--scheme direct");
    constexpr double tolerance = 1e-8 * 0.3;
    EXPECT_NEAR(summary_value("force"), one.force, tolerance) << one.kinematics;
    EXPECT_NEAR(summary_value("lateral_force"), one.lateral, tolerance) << one.kinematics;
    EXPECT_NEAR(summary_value("spin_moment"), one.moment, tolerance) << one.kinematics;
    EXPECT_NEAR(summary_value("slip_share"), one.slipping / one.touching, 1e-12) << one.kinematics;
  }
}

// The same program: a shift to Fx = -0.6 mu Fn [mm], and the creepage after five steps of an
// element under this force, where 94 of 316 elements slip. CONTACT iterates to 1e-7.
TEST_F(ContactInputs, HaveContactsCreepageAfterAShift) {
  const std::string shift = case_of({.first = "201110",
                                     .kinematics = "1. -0.6 0. 0.",
                                     .bodies = "0.28 0.28 1. 1.",
                                     .place = "-3\n 20 20 1. 1. 1."},
                                    "0.3");
  const std::string first =
      "3 MODULE\n 002110\n 102000\n 0101541\n 1. -0.6 0. 0.\n 0. 0.1 1000.\n 0.28 0.28 1. 1.\n";
  const std::string next = "3 MODULE\n 002110\n 100000\n 0101541\n 1. -0.6 0. 0.\n";
  const std::string input = shift + first + next + next + next + next + next + "0 MODULE\n";
  solve(input, "--scheme direct --case 6");
  EXPECT_NEAR(of_shift("shift"), 0.0883594083873, 5e-10);
  EXPECT_EQ(summary_value("steps"), 5);
  EXPECT_NEAR(summary_value("creepage"), 0.0384812944864, 4e-7);
  EXPECT_NEAR(summary_value("slip_share"), 94.0 / 316, 1e-12);
  solve(input, "--case 6");
  // CONTACT's elements have an error of 5 % so soon after a shift.
  EXPECT_NEAR(summary_value("creepage"), 0.0384812944864, 0.002);
}

// The example cattaneo, case 2: 177 elements, of which 132 slip, and a shift of 8.155e-3 mm.
TEST_F(ContactInputs, HaveTheExampleOfCattaneo) {
  const std::string input = case_of({.first = "201120",
                                     .kinematics = "9.1954 -0.875 0. 0.",
                                     .bodies = "0.42 0.42 200. 200.",
                                     .place = "-3\n 19 19 1. 1. 1.266666667"},
                                    "0.4") +
                            "0 MODULE\n";
  solve(input, "--scheme direct");
  EXPECT_NEAR(of_shift("shift"), 8.155e-3, 5e-7);
  EXPECT_NEAR(of_shift("slip_share"), 132.0 / 177, 1e-12);
  EXPECT_NEAR(of_shift("force"), -3.218, 5e-4);
  solve(input);
  EXPECT_NEAR(of_shift("shift"), 8.155e-3, 5e-6);  // 15 by 15 and 16 by 16 elements
  EXPECT_NEAR(of_shift("slip_share"), 132.0 / 177, 0.01);
}

// Examples in steady rolling with microslip's own elements, which differ by the error of CONTACT's
// elements: 40 in the length of the contact have 1.8 % of full sliding with spin.
TEST_F(ContactInputs, HaveExamplesOfSteadyRolling) {
  const struct {
    const char* name;
    Words words;
    const char* friction;
    double force, lateral, moment;  ///< x and y of the scene
    double full, tolerance;         ///< of the moment, over full times 4 mm
  } examples[] = {
      {"fastsim, case 1",
       {.kinematics = "82000. 0. -0.000625 0.000625",
        .bodies = "0.28 0.28 82000. 82000.",
        .rolling = "0. 0.4 30000.",
        .place = "-3\n 44 44 8. 4. 1.1"},
       "0.3",
       0,
       -14940,
       -48210,
       24600,
       0.018},
      {"ertz_temperature, case 4, which rolls towards -x",
       {.kinematics = "100000. -0.002 0.001 0.0002",
        .bodies = "0.28 0.28 82000. 82000.",
        .rolling = "180.d 0.2 30000.",
        .place = "1\n 216 45 -7.9 -11.25 0.2 0.5\n 1 1\n 0.001015 0. 0.0004215 0. 0. 0."},
       "0.3",
       -21820,
       4476,
       -46260,
       30000,
       0.006},
      {"tractcurv, case 3",
       {.kinematics = "106700. 0.0008 0. 0.",
        .bodies = "0.28 0.28 82000. 82000.",
        .rolling = "0. 0.5 10000.",
        .place = "-2\n 48 44 0.0008 0.5 1.1"},
       "0.33",
       -16700,
       0,
       0,
       35211,
       0.008}};
  for (const auto& [name, words, friction, force, lateral, moment, full, tolerance] : examples) {
    solve(case_of(words, friction) + "0 MODULE\n");
    EXPECT_NEAR(summary_value("full_sliding_force"), full, 1) << name;
    EXPECT_NEAR(summary_value("force"), force, tolerance * full) << name;
    EXPECT_NEAR(summary_value("lateral_force"), lateral, tolerance * full) << name;
    EXPECT_NEAR(summary_value("spin_moment"), moment, tolerance * full * 4) << name;
  }
}

// The example carter2d: 0.648 of full sliding with 50 elements, where Carter has 0.64.
TEST_F(ContactInputs, HaveTheExampleOfCarter) {
  const std::string input =
      case_of({.kinematics = "35780. -0.00024 0. 0.",
               .bodies = "0.28 0.28 82000. 82000.",
               .rolling = "0. 0.0401 30000.",
               .place = "3\n 55 1 -1.05 0. 0.04 200.\n 1 1\n 0.001 0. 0. 0. 0. 0."},
              "0.3") +
      "0 MODULE\n";
  solve(input);
  EXPECT_NEAR(summary_value("force_ratio"), 0.64, 1e-5);
  EXPECT_NEAR(summary_value("force"), 0.648 * 0.3 * 178.9, 0.01 * 0.3 * 178.9);
  solve(input, "--scheme direct");
  EXPECT_NEAR(summary_value("force_ratio"), 0.648, 0.005);
}

// CONTACT takes DX = 0.5714 in the place of DQ by its other solvers (m_sdis.f90, check_roll_stepsize).
TEST_F(ContactInputs, HaveTheStepOfSteadyRollingByConvexGs) {
  const auto ratio = [&](const std::string& solver, const std::string& step) {
    write("3 MODULE\n 203100\n 022020\n 00" + solver + "01411\n 300 30 30 1 1.0E-06\n" +
          (solver == "2" ? " 0.9 1.0 1 1.0\n" : "") +
          " 80000.0 0.0005 0.0005 0.0001\n 0.3 0.3\n 0.000d " + step +
          " 1000.0\n 0.28 0.28 82000.0 82000.0\n -3\n 21 21 6.0 4.0 1.0\n0 MODULE\n");
    const std::string text = run_in_folder("import case.inp --scheme direct").output;
    const std::size_t at = text.find("\n  ratio ");
    return at == std::string::npos ? 0 : std::stod(text.substr(at + 9));
  };
  EXPECT_NEAR(ratio("2", "2.0"), 3.5, 1e-6);
  EXPECT_EQ(ratio("2", "0.5714"), 1);
  EXPECT_EQ(ratio("0", "2.0"), 1);
}

TEST_F(ContactInputs, HaveOneLineForEachRefusal) {
  write(good_input);
  expect_refused("", "missing an input file of CONTACT, as case.inp");
  expect_refused("no.inp", "no.inp: cannot read it: No such file or directory");
  expect_refused("case.inp --case 0", "--case 0: expected a number from 1 on");
  expect_refused("case.inp --case 2", "--case 2: expected a case of case.inp, 1 to 1");
  expect_refused("case.inp --scheme own", "--scheme 'own': expected remembered or direct");
  expect_refused("case.inp --to case.inp",
                 "--to 'case.inp': expected a file that is not there yet");
  write("% a file\n" + good_case);
  expect_refused("case.inp --to new.info", "case.inp:12: the file ends here, expected MODULE");
  write(replaced(replaced(good_input, "022020", "022420"), "  -3 ", " 1 2 3 4\n -3 "));
  expect_refused("case.inp --to new.info", "case.inp:4: M (MATER) = 4: expected 0, elastic bodies");
  write(good_run);
  expect_refused("case.inp --to new.info",
                 "case.inp has 4 cases: expected --case and one of 1 to 4; --list describes them");
  write(std::string("3 MODULE\n\0 1\n", 12));
  EXPECT_EQ(run_in_folder("import case.inp").status, 1);
  write("problem steady\n");
  expect_refused("case.inp", "case.inp:1: MODULE = problem: expected a whole number");
  write(good_run.substr(0, good_run.rfind(" 102000")));
  const Outcome cut = run_in_folder("import case.inp --list");
  EXPECT_EQ(cut.status, 1);
  EXPECT_EQ(cut.output, "case 1: a shift of an ellipse\n");
  EXPECT_EQ(std::ranges::count(cut.error, '\n'), 1);
}

TEST_F(ContactInputs, AreWrittenToStandardOutputOrAFile) {
  write(replaced(good_input, "\n", "\r\n"));
  const Outcome shown = run_in_folder("import case.inp");
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.error, "");
  EXPECT_EQ(run_in_folder("import case.inp --to sub/a.info").status, 0);
  EXPECT_EQ(text_of(folder_ / "sub/a.info"), shown.output);
  EXPECT_EQ(run_in_folder("import case.inp --list").output,
            "case 1: steady rolling of an ellipse\n");
  write(replaced(good_input, "203100", "203101"));
  const Outcome noted = run_in_folder("import case.inp");
  EXPECT_EQ(noted.status, 0);
  EXPECT_EQ(noted.error,
            "microslip: case.inp:3: S (STRESS) = 1: stresses below the surface are left out\n");
  const Outcome run = run_in_folder("case.inp");
  EXPECT_NE(run.error.find("'microslip import case.inp' makes one of it"), std::string::npos)
      << run.error;
}

}  // namespace microslip::contact_inputs_test
