// SPDX-License-Identifier: GPL-3.0-or-later
// Contact ellipses as they are typed: tables, units, and a line for what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "property/samples.hpp"
#include "robustness/executables.hpp"

namespace microslip::ellipses_test {

class Ellipses : public Executables {
 protected:
  void SetUp() override {
    Executables::SetUp();
    run_in_folder("init ellipse");
  }

  Outcome solve(const std::string& settings) const {
    return run_in_folder("ellipse.info --quiet " + settings);
  }

  /// \param error  behind the program's name
  void expect_refused(const std::string& settings, const std::string& error) const {
    const Outcome outcome = solve(settings);
    EXPECT_EQ(outcome.status, 1) << settings;
    EXPECT_EQ(outcome.error.find("microslip: " + error), 0U) << outcome.error;
    EXPECT_FALSE(fs::exists(folder_ / "out")) << settings;
  }

  /// Numbers of the summary after a run.
  std::map<std::string, double> summary(const std::string& settings) const {
    const Outcome outcome = solve(settings);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    std::istringstream lines(text_of(folder_ / "out" / "summary.tsv"));
    std::map<std::string, double> values;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      std::string name;
      double value = 0;
      if (line[0] != '#' && std::getline(cells, name, '\t') && cells >> value) values[name] = value;
    }
    return values;
  }
};

TEST_F(Ellipses, HaveTheSameResultInOtherUnitsAndByTheirSemiAxes) {
  const auto found = summary("");
  const auto again = summary(
      "--set contact.normal_load=0.08MN --set contact.radius_1=46cm --set load.spin=1e-4 "
      "--set load.creepage=0.05%");
  EXPECT_NEAR(again.at("force"), found.at("force"), 1e-6 * std::abs(found.at("force")));
  std::ostringstream axes;
  axes.precision(17);
  axes << "--set contact.radius_1= --set contact.lateral_radius_2= --set contact.half_width="
       << found.at("half_width")
       << " --set contact.lateral_half_width=" << found.at("lateral_half_width");
  const auto by_axes = summary(axes.str());
  EXPECT_NEAR(by_axes.at("spin_moment"), found.at("spin_moment"), 1e-6 * found.at("spin_moment"));
}

// The motions that follow from resultants are there, and those that are 0 are not.
TEST_F(Ellipses, HaveALineWithTheMotionsThatFollow) {
  const auto line = [&](const std::string& settings) {
    return run_in_folder("ellipse.info " + settings).output;
  };
  const std::string held =
      line("--set load.spin= --set load.lateral_creepage= --set load.lateral_force=-5kN");
  EXPECT_NE(held.find(", lateral creepage 0.00"), std::string::npos) << held;
  EXPECT_EQ(held.find("spin 0"), std::string::npos) << held;
  const std::string turned = line("--set load.spin= --set load.spin_moment=\"1 N m\"");
  EXPECT_NE(turned.find(", spin "), std::string::npos) << turned;
  const std::string plain = line("--set load.spin= --set load.lateral_creepage=");
  EXPECT_EQ(plain.find("lateral creepage"), std::string::npos) << plain;
}

TEST_F(Ellipses, AreExplainedBesideALineContact) {
  const Outcome spins = run_in_folder("explain ellipse.info");
  EXPECT_NE(spins.output.find("Kalker's coefficients: C11 = 4.54"), std::string::npos)
      << spins.output;
  EXPECT_NE(spins.output.find("no line contact would do"), std::string::npos);
  const std::string along = "--set load.spin= --set load.lateral_creepage=";
  const Outcome line = run_in_folder("explain ellipse.info " + along);
  const std::string advice = line.output.substr(line.output.find("a line contact would do"));
  const auto number = [&](const std::string& key) {
    std::istringstream words(advice.substr(advice.find(key) + key.size()));
    std::string word;
    words >> word;
    return word;
  };
  const std::string width = number("kernel.width");
  const double force = summary(along).at("force");
  const double half_width = summary(along).at("half_width");
  std::ostringstream scene;
  scene.precision(17);
  scene << "problem steady\nmaterial { youngs_modulus 210 GPa\npoisson_ratio 0.28 }\n"
        << "contact { half_width " << half_width << "\npeak_traction "
        << number("contact.peak_traction") << " }\nkernel { type strip\nwidth " << width
        << " }\ngrid { elements 20 }\nload { creepage 0.0005 }\n";
  std::ofstream(folder_ / "line.info") << scene.str();
  ASSERT_EQ(run_in_folder("line.info --quiet").error, "");
  std::string text = text_of(folder_ / "out" / "summary.tsv");
  const double of_line = std::stod(text.substr(text.find("\nforce\t") + 7));
  EXPECT_NEAR(of_line * std::stod(width), force, 0.03 * 24000);
  EXPECT_NEAR(of_line * std::stod(width) / force, 1, 0.03);
}

// Kalker's coefficients are there from a/b = 0.01 on, ellipses from 0.001 on.
TEST_F(Ellipses, AreExplainedWhereTheyAreVeryWide) {
  const std::string wide =
      "--set contact.normal_load= --set contact.radius_1= --set contact.lateral_radius_2= --set "
      "contact.friction= --set contact.half_width=0.5 --set contact.lateral_half_width=200 --set "
      "contact.peak_traction=300 --set grid.rows=60 --set grid.elements=3";
  const Outcome explained = run_in_folder("explain ellipse.info " + wide);
  EXPECT_EQ(explained.status, 0) << explained.error;
  EXPECT_EQ(explained.output.find("Kalker's coefficients"), std::string::npos);
  const Outcome curve = run_in_folder("curve ellipse.info --points 3 " + wide);
  EXPECT_EQ(curve.status, 0) << curve.error;
  const Outcome beside = run_in_folder("curve ellipse.info --points 3 --beside polach " + wide);
  EXPECT_EQ(beside.status, 1);
  EXPECT_NE(beside.error.find("curve.beside = 'polach': expected nothing, as laws are for Hertz's"),
            std::string::npos)
      << beside.error;
}

// Rounding grows with the cells.
TEST_F(Ellipses, AreSolvedOnFineRows) {
  const int rows = takes_all_samples() ? 40 : 20;
  const Outcome fine = solve("--set grid.rows=" + std::to_string(rows) +
                             " --set grid.elements=" + std::to_string(rows) +
                             " --set load.creepage=0 --set load.lateral_creepage=0 --set "
                             "'load.spin=0.9 1/m'");
  EXPECT_EQ(fine.status, 0) << fine.error;
}

TEST_F(Ellipses, AreWarnedOfSpinInAnotherUnit) {
  const Outcome large = solve("--set load.spin=0.2");
  EXPECT_EQ(large.status, 0);
  EXPECT_NE(large.error.find("load.spin = 0.2: the slip by this spin"), std::string::npos)
      << large.error;
  EXPECT_EQ(solve("--set 'load.spin=0.2 1/m'").error, "");
}

TEST_F(Ellipses, TakeForcesAndTheMomentInAnyMixture) {
  const auto motions = summary("");
  std::ostringstream resultants;
  resultants.precision(17);
  resultants << "--set load.lateral_creepage= --set load.lateral_force="
             << motions.at("lateral_force")
             << "N --set load.spin= --set load.spin_moment=" << motions.at("spin_moment") / 1000
             << "'N m'";
  const auto found = summary(resultants.str());
  EXPECT_NEAR(found.at("lateral_creepage"), motions.at("lateral_creepage"), 1e-9);
  EXPECT_NEAR(found.at("spin"), motions.at("spin"), 1e-10);
  const auto ratio = summary("--set load.creepage= --set load.force_ratio=-0.5");
  EXPECT_NEAR(ratio.at("force"), -0.5 * ratio.at("full_sliding_force"), 1e-6);
}

TEST_F(Ellipses, AreRefusedInOneLineThatNamesTheKey) {
  expect_refused("--set load.force=1kN",
                 "ellipse.info:28: expected only one of 'load.creepage' and 'load.force'");
  expect_refused("--set load.creepage= --set load.force=30kN",
                 "load.force = 30000: expected less than full sliding, 24000 N, in absolute value");
  expect_refused("--set load.spin= --set load.spin_moment=1kN",
                 "load.spin_moment = '1kN': expected a number in N mm or another of its kind (N m, "
                 "kN m)");
  expect_refused("--set grid.rows=101 --set grid.elements=5",
                 "grid.rows = 101: expected a whole number 1 ... 100 in an ellipse");
  expect_refused("--set grid.rows=5 --set grid.elements=1",
                 "grid.elements = 1: expected a whole number 2 ... 100 in an ellipse");
  expect_refused("--set grid.rows=5", "missing key 'grid.elements'");
  expect_refused("--set contact.lateral_radius_2=-300",
                 "contact.lateral_radius_2 = -300: expected a number > 0, as the "
                 "other body is flat, by contact.lateral_radius_1");
  expect_refused(
      "--set contact.lateral_radius_1=-290",
      "contact.lateral_radius_1 = -290: expected a number > 0, or for a concave body one "
      "below -300, as its radius is larger than contact.lateral_radius_2");
  expect_refused("--set contact.lateral_radius_2=0.5",
                 "ellipse.info:17: contact.radius_1 = 460: expected radii of an ellipse with a/b "
                 "from 0.001 to 10");
  expect_refused(
      "--set kernel.type=plane",
      "key 'kernel.type' has no role here: it is for line contacts, not for this ellipse");
  expect_refused("--set problem=transient", "missing keys 'step.ratio', 'start.type'");
  expect_refused("--set problem=cylinder",
                 "ellipse.info:20: contact.lateral_radius_2: expected a line contact here");
  expect_refused("--set load.spin= --set load.creepage= --set load.lateral_creepage=",
                 "missing key 'load.creepage' or ");
  EXPECT_EQ(run_in_folder("response ellipse.info").status, 1);
}

// The estimate is below the target, and so is the difference to a finer grid.
TEST_F(Ellipses, AreSolvedToATarget) {
  const auto fine = summary("--set grid.rows=24 --set grid.elements=25");
  const auto found = summary("--target-error 3e-3");
  EXPECT_LE(found.at("estimated_error"), 3e-3);
  EXPECT_GT(found.at("estimated_error"), 0);
  const double most = fine.at("full_sliding_force");
  EXPECT_NEAR(found.at("force"), fine.at("force"), 3e-3 * most);
  EXPECT_NEAR(found.at("lateral_force"), fine.at("lateral_force"), 3e-3 * most);
  EXPECT_NE(text_of(folder_ / "out" / "summary.tsv").find("picked: grid.rows "), std::string::npos);
  fs::remove_all(folder_ / "out");
  expect_refused("--target-error 0.5", "target_error = 0.5: expected a number in [1e-11, 0.1]");
  expect_refused("--target-error 1e-3 --set grid.rows=9",
                 "key 'grid.rows' has no role here: it is for ellipses without target_error");
  const Outcome outcome = solve("--target-error 1e-9");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.error.find("target_error = 1e-09: expected about "), std::string::npos)
      << outcome.error;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(run_in_folder("sweep ellipse.info --quiet --set 'sweep.target_error=3e-2 1e-2'").status,
            0);
  run_in_folder("init ellipse_transient");
  const Outcome steps = run_in_folder("ellipse_transient.info --target-error 1e-3");
  EXPECT_EQ(steps.status, 1);
  EXPECT_NE(steps.error.find("key 'target_error' has no role here"), std::string::npos)
      << steps.error;
}

TEST_F(Ellipses, ConvergeOnRowsThatFit) {
  EXPECT_EQ(run_in_folder("converge ellipse.info --elements \"5 7 10\" --out converged").status, 0);
  const std::string table = text_of(folder_ / "converged" / "converge.tsv");
  EXPECT_NE(table.find("\nrows\t10\t"), std::string::npos) << table;
  EXPECT_NE(text_of(folder_ / "converged" / "advice_timing.tsv")
                .find("for an error of 0.001 in the forces"),
            std::string::npos);
  Outcome outcome = run_in_folder("converge ellipse.info --elements \"10 70\"");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("converge.elements = 70: expected at most 66 in an ellipse"),
            std::string::npos)
      << outcome.error;
  outcome = run_in_folder("converge ellipse.info --reference chebyshev");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("expected best or fine for an ellipse"), std::string::npos)
      << outcome.error;
}

// Each force is below full sliding, and the moment below that of turning, but not all together.
TEST_F(Ellipses, SayThatResultantsAreTooMuchTogether) {
  const Outcome outcome = solve(
      "--set load.creepage= --set load.force_ratio=0.9 --set load.spin= "
      "--set load.spin_moment_ratio=0.9");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.error.find("stick and slip of the contact are found up to 0."),
            std::string::npos)
      << outcome.error;
}

TEST_F(Ellipses, AreWarnedOfWhereTheirElementsAreTooFew) {
  const Outcome coarse = solve("--set grid.rows=4 --set grid.elements=4 --set load.spin=1/m");
  EXPECT_NE(coarse.error.find("the change of the result from rows and elements"),
            std::string::npos);
  const Outcome other = solve("--set grid.rows=20 --set grid.elements=4");
  EXPECT_NE(other.error.find("rows and elements do not fit a/b = 1.3"), std::string::npos)
      << other.error;
  EXPECT_NE(other.error.find("9 rows of 10 elements have a smaller error"), std::string::npos)
      << other.error;
  EXPECT_EQ(solve("").error, "");
  // Rows of a wide ellipse are nearly alone: more of them with two elements each would be worse.
  EXPECT_EQ(solve("--set contact.radius_1= --set contact.lateral_radius_2= --set "
                  "contact.half_width=5 --set contact.lateral_half_width=2500 --set "
                  "contact.normal_load=30MN --set grid.rows=20 --set grid.elements=16 --set "
                  "load.spin=0")
                .error,
            "");
}

// Nor is a grid advised that would have more than 100 rows.
TEST_F(Ellipses, AreNotWarnedWhereNoOtherGridIsAllowed) {
  const auto explanation_of = [&](const std::string& grid) {
    return run_in_folder(
               "explain ellipse.info --set contact.radius_1= --set contact.lateral_radius_2= --set "
               "contact.half_width=0.05 --set contact.lateral_half_width=5 --set "
               "contact.normal_load=600N --set load.spin=0 " +
               grid)
        .output;
  };
  EXPECT_NE(explanation_of("--set grid.rows=10 --set grid.elements=40").find("do not fit"),
            std::string::npos);
  EXPECT_EQ(explanation_of("--set grid.rows=15 --set grid.elements=100").find("do not fit"),
            std::string::npos);
}

TEST_F(Ellipses, AreSweptWithTheirUnits) {
  EXPECT_EQ(run_in_folder("sweep ellipse.info --quiet --set load.creepage= --set "
                          "'sweep.load.force=1 kN | 2 kN' --out s")
                .status,
            0);
  const std::string table = text_of(folder_ / "s" / "sweep.tsv");
  EXPECT_NE(table.find("load.force [N]: swept"), std::string::npos);
  EXPECT_NE(table.find("\n2\t2000\t2000\t"), std::string::npos) << table;
}

TEST_F(Ellipses, AreDrawn) {
  ASSERT_EQ(solve("").status, 0);
  EXPECT_EQ(run_in_folder("plot out").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out.svg"));
  EXPECT_EQ(run_in_folder("plot out --x 0:1").error,
            "microslip: --x: expected a line contact, a sweep or a curve with it\n");
}

// The tables lie beside the scene, whatever the folder in which the program runs.
TEST_F(Ellipses, MayBeContactsOfAnyShape) {
  const std::string scene = "'" MICROSLIP_SOURCE "/examples/patch.info' ";
  const Outcome solved = run_in_folder(scene + "--quiet --out egg");
  EXPECT_EQ(solved.status, 0);
  EXPECT_EQ(solved.error, "");
  EXPECT_NE(text_of(folder_ / "egg" / "edges.tsv").find("lobe\trow\ty"), std::string::npos);
  EXPECT_NE(text_of(folder_ / "egg" / "summary.tsv").find("spin_moment"), std::string::npos);
  EXPECT_EQ(run_in_folder("plot egg").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "egg.svg"));
  const Outcome explained = run_in_folder("explain " + scene);
  EXPECT_NE(explained.output.find("steady rolling of a patch"), std::string::npos)
      << explained.output;
  const std::pair<const char*, const char*> refused[] = {
      {"contact.half_width=3",
       "expected only one of 'contact.patch_file' and 'contact.half_width'"},
      {"contact.bound_file=none.tsv", "contact.bound_file = 'none.tsv': "},
      {"contact.patch_file=" MICROSLIP_SOURCE "/examples/patch_bound.tsv",
       "expected a column 'trailing'"},
      {"problem=cylinder", "contact.patch_file: expected a line contact here"},
      {"kernel.type=plane", "it is for line contacts, not for this patch"},
  };
  for (const auto& [setting, error] : refused) {
    const Outcome outcome = run_in_folder(scene + "--quiet --set " + setting);
    EXPECT_EQ(outcome.status, 1) << setting;
    EXPECT_NE(outcome.error.find(error), std::string::npos) << outcome.error;
  }
}

}  // namespace microslip::ellipses_test
