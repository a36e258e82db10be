// SPDX-License-Identifier: GPL-3.0-or-later
// load.file: runs from a table of distance or time, creepage, force or velocities.
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>

#include "microslip/scene/table.hpp"
#include "robustness/bad_scenes.hpp"

namespace microslip::run_files_test {

class RunFiles : public BadScenes {
 protected:
  void write(const std::string& text) const { std::ofstream(folder_ / "run.tsv") << text; }

  /// \param header  of the columns
  /// \param row     at a part of the run in [0, 1]
  void write(const std::string& header, int rows,
             const std::function<std::string(double)>& row) const {
    std::string text = "# made by a test\n" + header + "\n";
    for (int i = 0; i < rows; ++i) text += row(i / (rows - 1.0)) + "\n";
    write(text);
  }

  std::string scene(const std::string& keys = "") const {
    return "problem transient\n" + good_contact + "start { type rest }\nload { file \"" +
           (folder_ / "run.tsv").string() + "\" }\n" + keys;
  }

  double end_of(const std::string& text, const std::string& quantity) const {
    const Outcome outcome = run(text, "");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return outcome.status == 0 ? summary_value(quantity) : std::nan("");
  }

  void expect_refused(const std::string& table, const std::string& named,
                      const std::string& options = "") const {
    write(table);
    expect_rejected(scene(), options, named);
  }
};

std::string text_of_numbers(std::initializer_list<double> numbers) {
  std::ostringstream text;
  text.precision(17);
  for (const double number : numbers) text << number << '\t';
  return text.str();
}

constexpr double creepage = 0.3;

// The same run as one load, over the distance, over time, and by velocities in other units.
TEST_F(RunFiles, OfOneLoadAreThatLoad) {
  const double expected = end_of(
      "problem transient\n" + good_contact +
          "start { type rest }\nstep { ratio 0.7 }\nmotion { distance 1.5 }\nload { creepage "
          "0.3 }\n",
      "force");
  const std::string steps = "step { ratio 0.7 }\n";
  write("q creepage", 5, [](double part) { return text_of_numbers({1.5 * part, creepage}); });
  EXPECT_NEAR(end_of(scene(steps), "force"), expected, 1e-12);
  write("q[um] creepage [%]", 5, [](double part) {
    return text_of_numbers({1500 * part, 100 * creepage});
  });
  EXPECT_NEAR(end_of(scene(steps), "force"), expected, 1e-12);
  write("t [s] v [mm/s] other creepage", 5, [](double part) {
    return text_of_numbers({part, 1 + part, 7, creepage});
  });
  EXPECT_NEAR(end_of(scene(steps), "force"), expected, 1e-12);
  write("t [ms] v [m/s] omega [rad/s]", 5, [](double part) {
    const double v = 1 + part;
    return text_of_numbers({1000 * part, v / 1000, v * (1 - creepage) / 460});
  });
  EXPECT_NEAR(end_of(scene(steps + "load { radius 46 cm }\n"), "force"), expected, 1e-12);
}

// To the force of each row, and between them.
TEST_F(RunFiles, OfAForceFollowIt) {
  write("q force", 21, [](double part) {
    return text_of_numbers({2 * part, -0.8 * std::sin(4 * part)});
  });
  EXPECT_NEAR(end_of(scene(), "force"), -0.8 * std::sin(4), 1e-12);
  EXPECT_EQ(summary_value("steps"), 20);
  const double by_rows = summary_value("cumulative_creep");
  EXPECT_NEAR(end_of(scene("step { ratio 0.25 }\n"), "force"), -0.8 * std::sin(4), 1e-12);
  EXPECT_NEAR(summary_value("cumulative_creep") / by_rows, 1, 2e-3);
  EXPECT_NEAR(end_of(scene("motion { distance 0.85 }\n"), "force"),
              -0.4 * (std::sin(1.6) + std::sin(1.8)), 1e-12);
  const std::string from_shift = "start { type cattaneo }\n";
  write("q force\n0 -0.5\n1 -0.5\n");
  EXPECT_NEAR(end_of("problem transient\n" + good_contact + from_shift + "load { file \"" +
                         (folder_ / "run.tsv").string() + "\" }\n",
                     "force"),
              -0.5, 1e-12);
}

// A wave of the creepage by rows that are parts of the wave, and by steps that are parts of a row.
TEST_F(RunFiles, OfAWaveAreTheSameByRowsAndByShorterSteps) {
  write("t [s]\tv [mm/s]\tcreepage", 401, [](double part) {
    return text_of_numbers({part, 4, 0.3 + 0.1 * std::sin(12 * part)});
  });
  const double by_rows = end_of(scene(), "force");
  const WrittenTable history = read_table("history", text_of(out() / "history.tsv"));
  EXPECT_EQ(history.table.rows(), 401U);
  EXPECT_NEAR(std::stod(std::get<std::string>(history.table.at(400, "t"))), 1, 1e-12);
  EXPECT_NEAR(end_of(scene("step { ratio 0.03 }\n"), "force") / by_rows, 1, 1e-4);
}

// Rows are many, and each would be a step of its own.
TEST_F(RunFiles, OutsideTheRangeOfASchemeAreWarnedOfByTheirExtremes) {
  write("q creepage", 200, [](double part) {
    return text_of_numbers({3 * part * (1 + part), 0.1});
  });
  const Outcome outcome = run(scene("step { scheme direct }\n"), "");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  const std::string line = "warning: step.ratio = ";
  const std::size_t first = outcome.error.find(line);
  ASSERT_NE(first, std::string::npos) << outcome.error;
  const std::size_t second = outcome.error.find(line, first + 1);
  ASSERT_NE(second, std::string::npos) << outcome.error;
  EXPECT_EQ(outcome.error.find(line, second + 1), std::string::npos) << outcome.error;
}

const std::string under_load = "normal_load 4\n radius_1 100\n friction 0.3";

std::string rolling_on(const std::string& contact, const std::filesystem::path& file) {
  return "problem transient\nmaterial { youngs_modulus 200\n poisson_ratio 0.28 }\ncontact { " +
         contact + " }\nkernel { type plane\n length 20 }\ngrid { elements 40 }\n" +
         "start { type rest }\nload { file \"" + file.string() + "\" }\n";
}

// The results follow the load, or half-width and peak that follow from the load.
TEST_F(RunFiles, OfAContactThatChangesFollowIt) {
  const std::string text = rolling_on(under_load, folder_ / "run.tsv");
  const auto size = [](double part) { return 1 + 0.3 * std::sin(5 * part); };
  write("q creepage normal_load [kN/m]", 301, [&](double part) {
    return text_of_numbers({12 * part, 0.002, 4 * size(part) * size(part)});
  });
  const double force = end_of(text, "force");
  EXPECT_NEAR(summary_value("full_sliding_force"), 0.3 * 4 * std::pow(size(1), 2), 1e-12);
  const WrittenTable history = read_table("history", text_of(out() / "history.tsv"));
  const auto value = [&](const std::string& column) {
    return std::stod(std::get<std::string>(history.table.at(300, column)));
  };
  const double a = value("half_width");
  EXPECT_NEAR(value("full_sliding"), 0.3 * 4 * std::pow(size(1), 2), 1e-12);
  EXPECT_LT(force, 0);

  const double start = a / size(1);
  const double peak = 0.3 * 2 * 4 / (std::numbers::pi * start);
  write("q creepage half_width peak_traction", 301, [&](double part) {
    return text_of_numbers({12 * part, 0.002, start * size(part), peak * size(part)});
  });
  const std::string by_size = rolling_on(
      "half_width " + text_of_numbers({start}) + "\n peak_traction " + text_of_numbers({peak}),
      folder_ / "run.tsv");
  EXPECT_NEAR(end_of(by_size, "force") / force, 1, 1e-3);  // linear in a instead of a^2
}

// A wheel that leaves the rail and comes back.
TEST_F(RunFiles, OfAContactThatIsLostGoOn) {
  const std::string text = rolling_on(under_load, folder_ / "run.tsv");
  write("q creepage normal_load\n0 0.002 4\n2 0.002 0\n3 0.002 0\n4 0.002 4\n9 0.002 4\n");
  EXPECT_LT(end_of(text, "force"), -0.1);
  EXPECT_LT(end_of(text + "step { ratio 0.7 }\n", "force"), -0.1);
  write("q force normal_load\n0 0 4\n2 -0.5 4\n3 0 0\n4 0 0\n5 -0.5 4\n");
  EXPECT_NEAR(end_of(text, "force"), -0.5, 1e-12);
}

TEST_F(RunFiles, ThatStepsAreTooLongForAreWarnedOf) {
  const std::string text = rolling_on(under_load, folder_ / "run.tsv");
  write("q creepage normal_load\n0 0.002 4\n2 0.002 0\n3 0.002 4\n9 0.002 4\n");
  const Outcome long_steps = run(text + "step { ratio 100 }\n", "");
  EXPECT_EQ(long_steps.status, 0);
  EXPECT_NE(long_steps.error.find("of load.file lies within a step"), std::string::npos)
      << long_steps.error;
  for (const std::string steps : {"step { ratio 1 }\n", ""}) {
    EXPECT_EQ(run(text + steps, "").error.find("load.file"), std::string::npos) << steps;
  }
}

// Friction that falls and rises again over 1 mm: a step of 0.5 mm that ends beside the lowest row has a
// force that is three times too large.
TEST_F(RunFiles, ThatBendWithinAStepAreWarnedOf) {
  const std::string text = rolling_on(under_load, folder_ / "run.tsv");
  const auto warned = [&](const std::string& ratio) {
    return run(text + "step { ratio " + ratio + " }\n", "").error.find("lies within a step") !=
           std::string::npos;
  };
  write(
      "q creepage friction\n0 0.002 0.3\n5.05 0.002 0.3\n5.55 0.002 0.01\n6.05 0.002 0.3\n"
      "6.5 0.002 0.3\n");
  EXPECT_TRUE(warned("1"));
  EXPECT_TRUE(warned("2"));
  EXPECT_EQ(run(text, "").error.find("within a step"), std::string::npos);
  write("q creepage friction\n0 0.002 0.3\n5 0.002 0.301\n6 0.002 0.302\n9 0.002 0.3\n");
  EXPECT_FALSE(warned("3"));
}

// Cattaneo's start is another code: a shift before the run. It needs none within the run, so that it
// goes with other schemes.
TEST_F(RunFiles, ThatBeginAtAStandstillUnderAForceAreShiftedToIt) {
  const std::string rest = rolling_on(under_load, folder_ / "run.tsv");
  std::string shifted = rest;
  shifted.replace(shifted.find("type rest"), 9, "type cattaneo force -0.5");
  write("t v force\n0 0 -0.5\n0.1 0 -0.5\n0.2 2 -0.5\n0.3 2 -0.5\n");
  const double creepage = end_of(shifted, "creepage");
  EXPECT_NEAR(end_of(rest, "creepage") / creepage, 1, 1e-6);
  EXPECT_EQ(run(shifted + "step { scheme direct ratio 1 }\n", "").status, 0);
  EXPECT_EQ(run(rest + "step { scheme direct ratio 1 }\n", "").status, 1);
}

// Load and friction fall together, so that what they carry between rows is less than the mean.
TEST_F(RunFiles, OfForcesThatAreNotCarriedBetweenRowsNameThePlace) {
  const std::string text = rolling_on(under_load, folder_ / "run.tsv");
  write(
      "q force normal_load friction\n0 0 4 0.3\n2 -1.17 4 0.3\n4 -0.128 1.3333 0.1\n"
      "5 -0.128 1.3333 0.1\n");
  const Outcome outcome = run(text + "step { ratio 1 }\n", "");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.error.find("microslip: behind q = "), 0U) << outcome.error;
  EXPECT_NE(outcome.error.find(" mm: force = -"), std::string::npos) << outcome.error;
}

TEST_F(RunFiles, OfContactsThatAreWrongAreRefused) {
  const std::string text = rolling_on(under_load, folder_ / "run.tsv");
  const auto refused = [&](const std::string& table, const std::string& named,
                           const std::string& options = "") {
    write(table);
    expect_rejected(text, options, named);
  };
  refused("q creepage normal_load\n0 0 4\n1 0 -1\n", "row 2: normal_load = -1: expected a number");
  refused("q force normal_load\n0 1 4\n1 1 3\n",
          "row 2: force = 1: expected an absolute value below full sliding, 0.9");
  refused("q force normal_load\n0 1 4\n1 1 0\n",
          "row 2: force = 1: expected 0 where bodies do not");
  refused("q creepage normal_load\n0 0 4\n1 0 400000\n", "kernel.length = 20: expected more than");
  refused("q creepage half_width\n0 0 4\n1 0 4\n", "column 'half_width': expected contact.half");
  refused("q creepage normal_load half_width\n0 0 4 1\n1 0 4 1\n", "column 'half_width': expected");
  refused("q creepage normal_load\n0 0 4\n1 0 5\n", "expected remembered, which alone",
          "--set step.scheme=direct --set step.ratio=1");
}

TEST_F(RunFiles, ThatAreWrongAreRefusedWithRowAndColumn) {
  expect_refused("t v creepage\n0 1 0.1\n2 1 0.2\n1 1 0.1\n", "row 3: t = 1: expected at least 2");
  expect_refused("q creepage\n0 0.1\n1 nan\n", "line 3: column 'creepage': 'nan' is not a finite");
  expect_refused("q creepage\n0 0.1\n", "number of rows = 1: expected at least 2");
  expect_refused("q [kg] creepage\n0 0.1\n1 0\n", "column 'q': unit 'kg': expected mm or another");
  expect_refused("q creepage\n0 0.1\n1\n", "line 3: expected 2 values, found 1");
  expect_refused("q force\n0 0\n1 -5\n",
                 "row 2: force = -5: expected an absolute value below full");
  expect_refused("q creepage force\n0 0 0\n1 0 0\n", "expected one of creepage, force and omega");
  expect_refused("q v\n0 1\n1 1\n", "expected one of creepage, force and omega");
  expect_refused("t creepage\n0 1\n1 1\n", "expected v where there is t, and only there");
  expect_refused("t v omega\n0 1 1\n1 1 1\n", "missing key 'load.radius'");
  expect_refused("t v omega\n0 1 1\n1 1 1\n", "load.radius = 0: expected", "--set load.radius=0");
  const std::string good = "q creepage\n0 0.1\n2 0.2\n";
  expect_refused(good, "key 'load.radius' has no role here", "--set load.radius=5");
  expect_refused(good, "expected only one of", "--set load.creepage=0.1");
  expect_refused(good, "motion.distance = 3: expected at most the distance of load.file, 2",
                 "--set motion.distance=3");
  expect_refused(good, "step.ratio = 0: expected at least one number > 0", "--set step.ratio=0");
  expect_refused(good,
                 "step.ratio = -1: expected numbers >= 1e-15 or 0; bodies roll back by rows of",
                 "--set 'step.ratio=1 -1'");
}

// A time loop, a logger and a list of steps meet steps of length 0.
TEST_F(RunFiles, DoNotFeelAStandstill) {
  const auto history = [&](const std::string& table, const std::string& options = "") {
    write(table);
    const Outcome outcome = run(scene(), options);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    std::istringstream lines(text_of(out() / "history.tsv"));
    std::string rows;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("#")) rows += line + '\n';
    }
    return rows;
  };
  const std::string moving = history("q creepage\n0 0.1\n0.2 0.3\n0.5 -0.1\n");
  EXPECT_EQ(history("q creepage\n0 0.1\n0 0.1\n0.2 0.3\n0.2 0.3\n0.2 0.3\n0.5 -0.1\n0.5 -0.1\n"),
            moving);
  const std::string same = "q creepage\n0 0.1\n0.2 0.3\n0.5 -0.1\n";
  EXPECT_EQ(history(same, "--set 'step.ratio=0 0.3 0 0 0.7 0'"),
            history(same, "--set 'step.ratio=0.3 0.7'"));
  EXPECT_EQ(history("q force half_width\n0 0 1\n0.2 0.5 1.1\n0.2 0.5 1.1\n0.5 -0.1 1\n",
                    "--set contact.half_width=1 --set step.tolerance=1e-2"),
            history("q force half_width\n0 0 1\n0.2 0.5 1.1\n0.5 -0.1 1\n",
                    "--set contact.half_width=1 --set step.tolerance=1e-2"));
  // It starts, stops, waits, and starts again.
  const std::string stops =
      history("t v creepage\n0 0 0.1\n1 0.4 0.3\n2 0 0.2\n9 0 0.7\n10 1 0.7\n");
  EXPECT_EQ(std::count(stops.begin(), stops.end(), '\n'), 1 + 4);  // the start, and three steps
  EXPECT_EQ(stops.find("nan"), std::string::npos);
}

}  // namespace microslip::run_files_test
