// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels of layers, of springs, and by their symbol in scenes: what is solved, warned of, or
// refused in one line.
#include <cmath>
#include <fstream>
#include <string>

#include "robustness/bad_scenes.hpp"

namespace microslip::kernels_test {

const std::string brush = R"(
problem steady
contact { half_width 1
  peak_traction 1 }
kernel { type winkler
  compliance 0.7 }
grid { elements 200 }
load { creepage 0.7 }
)";

const std::string by_symbol = R"(
problem steady
contact { half_width 1
  peak_traction 1 }
kernel { type symbol
  table symbol.tsv }
grid { elements 100 }
load { force_ratio -0.5 }
)";

class Kernels : public BadScenes {
 protected:
  void write_table(const std::string& text) const {
    std::ofstream(scene_file().parent_path() / "symbol.tsv") << text;
  }
  void expect_rejected_table(const std::string& text, const std::string& named) const {
    write_table(text);
    expect_rejected(by_symbol, "", named);
  }
};

// Half of full sliding and a little more: 1/2 + 1/pi at m = 1.
TEST_F(Kernels, SpringsAreSolvedWithoutAMaterial) {
  const Outcome outcome = run(brush, "");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");  // in closed form
  EXPECT_NEAR(summary_value("force"), -(0.5 + 0.78539816339744831), 1e-13);
}

TEST_F(Kernels, WithoutAnInversionAreSolvedByElementsWithAWarning) {
  const Outcome outcome = run(brush,
                              "--set kernel.type=strip --set kernel.width=2 "
                              "--set material.shear_modulus=1 --set material.poisson_ratio=0.25");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("the kernel is strip with a layer, not a half-space"),
            std::string::npos)
      << outcome.error;
}

TEST_F(Kernels, OfSpringsAreRefused) {
  expect_rejected(brush, "--set kernel.compliance=", "missing key 'kernel.compliance'");
  for (const std::string value : {"0", "-1", "1e-51", "nan", "x"}) {
    expect_rejected(brush, "--set kernel.compliance=" + value, "kernel.compliance = ");
  }
  expect_rejected(brush, "--set kernel.compliance='1 mm'", "kernel.compliance = '1 mm': expected");
  expect_rejected(brush, "--set kernel.width=1", "key 'kernel.width' has no role here");
  expect_rejected(brush, "--set kernel.table=x.tsv", "key 'kernel.table' has no role here");
  expect_rejected(brush, "--set material.shear_modulus=1",
                  "key 'material.shear_modulus' has no role here");
  expect_rejected(brush, "--set direction=lateral", "key 'direction' has no role here");
  expect_rejected(brush, "--set material.dundurs_beta=0.1",
                  "key 'material.dundurs_beta' has no role here");
  expect_rejected(brush, "--set load.creepage= --set load.stick_ratio=0.5",
                  "load.stick_ratio = 0.5: expected kernel.type plane without a layer");
  expect_rejected(brush, "--set method=chebyshev",
                  "kernel.type = 'winkler': expected strip or plane without a layer for Chebyshev");
  expect_rejected(brush, "--set leading_edge=known_edge",
                  "kernel.type = 'winkler': expected strip or plane without a layer for Chebyshev");
  const Outcome outcome = run_program("microslip", "response", brush, "");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("its kernel is winkler, not a half-space"), std::string::npos)
      << outcome.error;
}

TEST_F(Kernels, OfLayersAreRefusedWithBodiesOfDifferentMaterial) {
  const std::string layer =
      "--set kernel.type=plane --set kernel.width= --set kernel.length=40 "
      "--set kernel.compliance=0.3 ";
  expect_rejected(good_scene, layer + "--set material.dundurs_beta=0.1 --set contact.friction=0.3",
                  "kernel.type = 'plane with a layer': expected plane for bodies of different");
  expect_rejected(good_scene, layer + "--set basis=quadratic --set grid.elements=21",
                  "basis = 'quadratic': expected constant or linear");
  EXPECT_EQ(run(good_scene, layer).status, 0);
}

TEST_F(Kernels, BySymbolsAreRefused) {
  const std::string names = "wave_number symbol\n";
  expect_rejected_table("", "kernel.table = 'symbol.tsv': ");
  expect_rejected_table("wave_number other\n1 1\n2 1\n", "expected a column 'symbol'");
  expect_rejected_table(names, "expected at least one row below the names");
  expect_rejected_table(names + "1 1\n",
                        "kernel.table = 'symbol.tsv': rows = 1: expected 2 to 1000");
  expect_rejected_table(names + "1 1\n0.5 1\n",
                        "wave_number = 0.5: expected more than the one before");
  expect_rejected_table(names + "0 1\n1 1\n", "wave_number = 0: expected");
  expect_rejected_table(names + "1 -1\n2 1\n", "symbol = -1: expected");
  expect_rejected_table(names + "1 nan\n2 1\n", "'nan' is not a finite number");
  expect_rejected_table(names + "1 1\n2 0.2\n", "symbol = 0.2: expected one that falls no faster");
  expect_rejected_table(names + "1 1\n2 3\n", "symbol = 3: expected one that rises no faster");
  expect_rejected_table("wave_number [mm] symbol\n1 1\n2 1\n", "column 'wave_number': unit 'mm'");
  expect_rejected_table(names + "1 1\n1e6 2e-6\n1e7 2e-7\n", "kernel.table = ");
}

TEST_F(Kernels, BySymbolsAreSolved) {
  write_table("wave_number [1/m] symbol\n1 1440\n1000 1.44\n1000000 0.00144\n");
  EXPECT_EQ(run(by_symbol, "").status, 0);
  const double creepage = summary_value("creepage");
  EXPECT_NEAR(creepage, 1.44 * (1 - std::sqrt(0.5)), 1e-4);  // Carter's
  write_table("wave_number symbol\n2 0.72\n100 0.0144\n");
  const Outcome outcome = run(by_symbol, "");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.error.find("kernel.table = 2: the first wave number is above"),
            std::string::npos)
      << outcome.error;
}

TEST_F(Kernels, SayWhatTheyLeaveOut) {
  std::ofstream(scene_file()) << brush;
  const Outcome springs = run_command(std::string(MICROSLIP_BIN) + "/microslip explain '" +
                                      scene_file().string() + "'");
  EXPECT_NE(springs.output.find("bodies are springs, as in FASTSIM"), std::string::npos)
      << springs.output;
}

}  // namespace microslip::kernels_test
