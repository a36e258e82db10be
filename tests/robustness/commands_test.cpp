// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the commands beside a run: scenes to start from, their cost, and the figures of results.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <regex>
#include <set>
#include <sstream>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/format.hpp"
#include "robustness/executables.hpp"

namespace microslip::commands_test {

class Commands : public Executables {
 protected:
  void expect_error(const std::string& words, const std::string& error) const {
    const Outcome outcome = run_in_folder(words);
    EXPECT_EQ(outcome.status, 1) << words;
    EXPECT_EQ(outcome.error, "microslip: " + error + "\n") << words;
    EXPECT_EQ(outcome.output, "") << words;
  }
};

TEST_F(Commands, AWordThatIsNone) {
  const std::string known =
      "; commands: init, import, keys, explain, response, curve, converge, table, plot, sweep, "
      "merge";
  expect_error(
      "swep",
      "'swep': expected a scene's file that is there or a command (did you mean 'sweep'?)" + known);
  expect_error("my.info", "'my.info': expected a scene's file that is there or a command" + known);
  expect_error("", "missing a scene: expected its file, as in 'microslip scene.info'; see --help");
  run_in_folder("init wheel");
  expect_error("init wheel line",
               "'line': expected no further word; a value with blanks is in quotes, as in --set "
               "'load.creepage=2 %'");
  expect_error("wheel.info --set load.creepage=2 % --quiet",
               "'%': expected no further word; a value with blanks is in quotes, as in --set "
               "'load.creepage=2 %'");
  expect_error("keys wheel",
               "'wheel': expected no further word; a value with blanks is "
               "in quotes, as in --set 'load.creepage=2 %'");
  const Outcome help = run_in_folder("--help");
  for (const char* command : {"init", "import", "keys", "explain", "response", "curve", "converge",
                              "table", "plot", "sweep", "merge"}) {
    EXPECT_NE(help.output.find(std::string("\n  microslip ") + command), std::string::npos);
    EXPECT_EQ(run_in_folder(std::string(command) + " --help").status, 0);
  }
}

TEST_F(Commands, EachSceneToStartFromIsSolvedAndDrawn) {
  for (const std::string kind : {"wheel", "line", "steady", "transient", "run", "cylinder"}) {
    const std::string scene = kind + ".info";
    const std::string table = kind == "run" ? " and run.tsv" : "";
    EXPECT_EQ(run_in_folder("init " + kind).output,
              "wrote " + scene + table + "; solve it with: microslip " + scene + "\n");
    expect_error("init " + kind, "--out '" + scene + "': expected a file that is not there yet");
    EXPECT_EQ(run_in_folder("init " + kind + " --out -").output, text_of(folder_ / scene));
    EXPECT_EQ(run_in_folder("explain " + scene).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_EQ(run_in_folder(scene).error, "");
    const Outcome drawn = run_in_folder("plot --to 'a '\\''figure'\\''.svg'");
    EXPECT_EQ(drawn.output, "drew a 'figure'.svg\n") << drawn.error;
    EXPECT_TRUE(text_of(folder_ / "a 'figure'.svg").ends_with("</svg>\n\n"));
    fs::remove_all(folder_ / "out");
  }
  EXPECT_EQ(run_in_folder("init sweep --out its/own/many.info").output,
            "wrote its/own/many.info; solve it with: microslip sweep its/own/many.info\n");
  EXPECT_NE(
      run_in_folder("explain its/own/many.info").output.find("78 cases, the first is: steady"),
      std::string::npos);
  expect_error("init stedy",
               "no scene 'stedy' (did you mean 'steady'?); expected wheel, ellipse, line, "
               "steady, transient, ellipse_transient, run, cylinder, sweep");
}

TEST_F(Commands, ExplainSaysTheScenesErrorsAndWarnings) {
  run_in_folder("init transient");
  const Outcome run = run_in_folder("transient.info --set half_width=3");
  const Outcome explained = run_in_folder("explain transient.info --set half_width=3");
  EXPECT_EQ(explained.status, 1);
  EXPECT_EQ(explained.error, run.error);
  EXPECT_EQ(explained.output, "");
  const Outcome direct =
      run_in_folder("explain transient.info --set step.scheme=direct --set step.ratio=0.03");
  EXPECT_NE(direct.output.find("Warnings\n  step.ratio = 0.03: this scheme is safe from 0.5"),
            std::string::npos)
      << direct.output;
  EXPECT_NE(direct.output.find("in 6734 steps"), std::string::npos) << direct.output;
}

TEST_F(Commands, ExplainSaysWhichSteadyMethodRuns) {
  run_in_folder("init steady");
  const Outcome hertz = run_in_folder("explain steady.info");
  EXPECT_NE(hertz.output.find("one stick zone is solved by inversion, to ten digits"),
            std::string::npos);
  const Outcome standard = run_in_folder("explain steady.info --set leading_edge=standard");
  EXPECT_NE(standard.output.find("differences over c = 1 elements, constant functions"),
            std::string::npos)
      << standard.output << standard.error;
}

// On a terminal, which `script` provides: after two seconds, and not before.
TEST_F(Commands, ProgressHasRateAndRemainingTime) {
  if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "no script";
  run_in_folder("init transient");
  const auto on_terminal = [&](const std::string& elements) {
    return run_command("cd '" + folder_.string() +
                       "' && script -qec 'timeout -s INT 4 " MICROSLIP_BIN
                       "/microslip transient.info --set grid.elements=" +
                       elements + "' /dev/null")
        .output;
  };
  EXPECT_EQ(on_terminal("21 --quiet"), "");
  const std::string line = on_terminal("21");
  EXPECT_TRUE(line.starts_with("microslip: force -1500 N/mm, -0.63662 of full sliding, creepage "))
      << line;
  EXPECT_TRUE(line.ends_with(", by remembered; tables in out\r\n")) << line;
  const std::string slow = on_terminal("20001");
  EXPECT_TRUE(std::regex_search(
      slow, std::regex("\rmicroslip: [0-9]+ of 40002, [0-9.]+ a second, [0-9]+ min [0-9]+ s left")))
      << slow;
  EXPECT_NE(slow.find("\nmicroslip: interrupted, nothing is written"), std::string::npos) << slow;
}

TEST_F(Commands, ResponseIsWrittenAndDrawn) {
  run_in_folder("init steady");
  run_in_folder("init transient");
  for (const std::string scene : {"steady.info", "transient.info"}) {
    const Outcome outcome = run_in_folder("response " + scene);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(run_in_folder("plot --to a.svg").output, "drew a.svg\n");
    EXPECT_TRUE(fs::exists(folder_ / "out/response.tsv"));
    fs::remove_all(folder_ / "out");
  }
  run_in_folder("response steady.info --shortest '1 cm' --longest 1m --wavelengths 3");
  const WrittenTable written = read_table("response", text_of(folder_ / "out/response.tsv"));
  ASSERT_EQ(written.table.rows(), 3);
  const char* const wavelengths[] = {"10", "100", "1000"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::stod(std::get<std::string>(written.table.at(i, "wavelength"))),
                std::stod(wavelengths[i]), 1e-10);
  }
}

/// Columns of response.tsv beside the closed form of plane strain, of the stick length that Carter
/// has.
TEST_F(Commands, ResponseOfCartersContactIsTheClosedForm) {
  run_in_folder("init steady");
  const std::string plane = " --set kernel.type=plane --set kernel.width= --set kernel.length=50";
  for (const double stick_ratio : {0.25, 0.9}) {
    const double force = -150 * 5 * std::numbers::pi * (1 - stick_ratio * stick_ratio);
    ASSERT_EQ(
        run_in_folder("response steady.info" + plane + " --set load.force=" + format_short(force))
            .error,
        "");
    const Table table = read_table("response", text_of(folder_ / "out/response.tsv")).table;
    ASSERT_EQ(table.rows(), 60);
    const double half_length = 5 * stick_ratio;
    const double k = 2 * (1 - 0.28) / (std::numbers::pi * 82000);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const auto number = [&](const char* column) {
        return std::stod(std::get<std::string>(table.at(i, column)));
      };
      const double kappa = 2 * std::numbers::pi * half_length / number("wavelength");
      const double j0 = std::cyl_bessel_j(0.0, kappa), j1 = std::cyl_bessel_j(1.0, kappa);
      const std::complex<double> response =
          1.0 /
          (j0 / std::complex(j0, j1) + std::complex(0.0, kappa * std::log(100 / half_length)));
      EXPECT_NEAR(number("slope_real") * k / half_length, -response.real(), 1e-10);
      EXPECT_NEAR(number("slope_imaginary") * k / half_length, -response.imag(), 1e-10);
      EXPECT_NEAR(number("size") / std::abs(response), 1, 1e-10);
      EXPECT_NEAR(number("phase"), std::arg(response), 1e-10);
      EXPECT_NEAR(number("wavelength_ratio") * 5, number("wavelength"), 1e-9);
    }
    EXPECT_NEAR(std::stod(std::get<std::string>(table.at(0, "wavelength"))), 0.3 * half_length,
                1e-5);
    EXPECT_NEAR(std::stod(std::get<std::string>(table.at(59, "wavelength"))), 300 * half_length,
                1e-2);
  }
}

TEST_F(Commands, ConvergeAdvisesAndIsDrawn) {
  for (const std::string kind : {"steady", "transient", "run"}) {
    run_in_folder("init " + kind);
    const std::string step_time = kind == "steady" ? "" : " --step-time '1 s'";
    const std::string error = kind == "steady" ? "1e-4" : "'1 %'";
    const Outcome outcome = run_in_folder(
        "converge " + kind + ".info --elements '11:10:21' --error " + error + step_time);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_TRUE(outcome.output.starts_with("for an error of ")) << outcome.output;
    EXPECT_EQ(std::ranges::count(outcome.output, '\n'), kind == "steady" ? 1 : 2);
    EXPECT_EQ(run_in_folder("plot --to a.svg").output, "drew a.svg\n");
    fs::remove_all(folder_ / "out");
  }
  run_in_folder("init cylinder");
  expect_error(
      "converge cylinder.info",
      "cylinder.info:5: problem = 'cylinder': expected steady or transient, which have a load");
  expect_error(
      "steady.info --set converge.error=1e-3",
      "key 'converge.error' has no role here: it is for microslip converge; known to this "
      "model: problem, method, leading_edge, material.shear_modulus, "
      "material.poisson_ratio, direction, contact.half_width, contact.peak_traction, kernel.type, "
      "kernel.width, grid.elements, basis, load.force, solver.type, solver.tolerance, "
      "solver.violation, solver.condition, target_error, material.youngs_modulus, "
      "material.dundurs_beta, material.shear_modulus_2, material.youngs_modulus_2, "
      "material.poisson_ratio_2, contact.normal_load, contact.roughness, contact.bound_polynomial, "
      "contact.bound_file, kernel.compliance, load.creepage, load.force_ratio, load.stick_ratio, "
      "contact.friction_law");
}

// Without a load all sticks that carries a traction, and a small load changes little.
TEST_F(Commands, ResponseWithoutALoad) {
  run_in_folder("init steady");
  std::ofstream(folder_ / "bound.tsv") << "x bound\n-5 0\n-3 0\n1 300\n3 0\n5 0\n";
  const auto slope = [&](const std::string& load) {
    const Outcome outcome = run_in_folder(
        "response steady.info --set contact.peak_traction= --set contact.bound_file=bound.tsv "
        "--set load.force=" +
        load);
    EXPECT_EQ(outcome.error, "");
    const Table summary = read_table("summary", text_of(folder_ / "out/summary.tsv")).table;
    for (std::size_t i = 0; i < summary.rows(); ++i) {
      const double value = std::stod(std::get<std::string>(summary.at(i, "value")));
      const std::string quantity = std::get<std::string>(summary.at(i, "quantity"));
      if (load == "0" && quantity.starts_with("stick_")) {
        EXPECT_EQ(value, quantity == "stick_edge" ? -3 : 3);
      }
      if (quantity == "steady_slope") return value;
    }
    return std::nan("");
  };
  EXPECT_NEAR(slope("0") / slope("-1e-8"), 1, 1e-5);
  EXPECT_GT(slope("-100") / slope("0"), 0.5);
  EXPECT_LT(slope("-100") / slope("0"), 0.95);
}

TEST_F(Commands, ResponseRefusesBodiesOfDifferentMaterial) {
  run_in_folder("init steady");
  expect_error(
      "response steady.info --set kernel.type=plane --set kernel.width= --set "
      "kernel.length=50 --set material.dundurs_beta=0.1 --set contact.friction=0.3",
      "the response: expected a contact with one stick zone, but the bodies differ in "
      "material");
}

TEST_F(Commands, ResponseRefusesWhatHasNoSingleStickZone) {
  for (const std::string kind : {"steady", "cylinder"}) run_in_folder("init " + kind);
  const std::string expected = "the response: expected a contact with one stick zone, but ";
  expect_error(
      "response cylinder.info",
      "cylinder.info:5: problem = 'cylinder': expected steady or transient, which have a load");
  expect_error("response steady.info --set load.force= --set load.creepage=1",
               expected + "all of it slides");
  expect_error("response steady.info --set kernel.width=0.01mm --set leading_edge=standard",
               expected + "the strip is too narrow for the inversion");
  std::ofstream(folder_ / "two.tsv") << "x bound\n-5 0\n-3 300\n-1 1\n1 1\n3 300\n5 0\n";
  std::ofstream(folder_ / "gap.tsv") << "x bound\n-5 0\n-3 300\n-1 0\n1 0\n3 300\n5 0\n";
  const Outcome two = run_in_folder(
      "response steady.info --set contact.peak_traction= --set contact.bound_file=two.tsv --set "
      "load.force=-500");
  EXPECT_EQ(two.status, 1);
  EXPECT_TRUE(two.error.starts_with("microslip: " + expected)) << two.error;
  expect_error(
      "response steady.info --set contact.peak_traction= --set contact.bound_file=gap.tsv "
      "--set load.force=0",
      expected + "its bound vanishes inside");
  EXPECT_EQ(
      run_in_folder("response steady.info --set load.force= --set load.creepage=0.00526829268 "
                    "--set kernel.type=plane --set kernel.width= --set kernel.length=50")
          .status,
      2);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  expect_error("response steady.info --wavelengths 1",
               "response.wavelengths = 1: expected a whole number from 2 to 100000");
  expect_error("response steady.info --shortest 3 --longest 2",
               "response.longest = 2: expected more than the shortest wavelength, 3");
  expect_error("response steady.info --shortest -3",
               "response.shortest = -3: expected a number > 0");
  EXPECT_EQ(run_in_folder("response steady.info --shortest 1e-9").status, 1);
  for (const std::string command : {"explain ", ""}) {
    const Outcome outcome = run_in_folder(command + "steady.info --set response.shortest=3");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.error.starts_with(
        "microslip: key 'response.shortest' has no role here: it is for microslip response; known"))
        << outcome.error;
  }
}

/// In the first column of the tables of keys, without marks of Markdown.
std::set<std::string> documented_keys() {
  std::set<std::string> keys;
  std::ifstream in(MICROSLIP_SOURCE "/docs/scenes.md");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| `")) continue;
    keys.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

TEST_F(Commands, AllKeysAreDocumented) {
  const std::set<std::string> documented = documented_keys();
  const std::string page = text_of(MICROSLIP_SOURCE "/packaging/man/microslip-scene.5");
  std::string printed = run_in_folder("keys").output;
  printed.insert(printed.begin(), '\n');
  for (const Key& key : keys_of_scenes()) {
    const std::string name(key.name);
    EXPECT_TRUE(documented.contains(name)) << name;
    EXPECT_NE(page.find("\n.B " + name + "\n"), std::string::npos) << name;
    EXPECT_NE(printed.find("\n" + name + " "), std::string::npos) << name;
  }
}

TEST_F(Commands, KeysArePrintedForWhoeverReadsThem) {
  const std::string text = run_in_folder("keys").output;
  EXPECT_EQ(run_in_folder("keys --format text").output, text);
  EXPECT_TRUE(std::regex_search(
      text, std::regex("material.poisson_ratio +combined Poisson ratio nu; of the driven body ")));
  EXPECT_NE(run_in_folder("keys --format markdown")
                .output.find("| `kernel.width` | width Δy of the strip | mm | > 0 | `kernel.type` "
                             "strip |\n"),
            std::string::npos);
  EXPECT_NE(run_in_folder("keys --format man")
                .output.find(".TP\n.B kernel.width\nwidth Dy of the strip (mm). > 0. For "
                             "kernel.type strip.\n"),
            std::string::npos);
  expect_error("keys --format html", "format 'html': expected text, markdown, man or completion");
}

// Each key that a run resolves is one of the list, so that explain can say what it means.
TEST_F(Commands, AllKeysOfRunsAreListed) {
  std::set<std::string> listed;
  for (const Key& key : keys_of_scenes()) listed.insert(std::string(key.name));
  for (const std::string kind : {"steady", "line", "wheel", "transient", "cylinder"}) {
    run_in_folder("init " + kind);
    const bool rolls = kind == "transient" || kind == "cylinder";
    ASSERT_EQ(run_in_folder(kind + ".info" + (rolls ? " --set step.scheme=relaxed" : "")).status,
              0);
    std::ifstream in(folder_ / "out/summary.tsv");
    bool is_parameter = false;
    for (std::string line; std::getline(in, line) && line.starts_with('#');) {
      if (!line.starts_with("#   ")) is_parameter = line == "# parameters";
      if (!is_parameter || !line.starts_with("#   ")) continue;
      const std::string name = line.substr(4, line.find(" = ") - 4);
      EXPECT_TRUE(listed.contains(name.substr(name.rfind(' ') + 1))) << line;  // or "derived" it
    }
  }
}

}  // namespace microslip::commands_test
