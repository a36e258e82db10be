// SPDX-License-Identifier: GPL-3.0-or-later
// What scenes warn of: columns that nobody reads, creepages and radii that are mistakes of units, and
// forces that are there at once.
#include <gtest/gtest.h>

#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip {
namespace {

const std::string steel =
    "material { shear_modulus 82 GPa poisson_ratio 0.28 }\n"
    "contact { half_width 5 mm peak_traction 300 MPa }\n"
    "kernel { type plane length 100 mm }\ngrid { elements 20 }\n";
const std::string transient = steel + "problem transient\nstart { type rest }\n";
const std::string run = transient + "load { file run.tsv radius 460 mm }\n";

/// All warnings, a line each.
std::string warnings(const std::string& text, const std::string& table = "") {
  Scene scene = scene_of(text);
  scene.read_files_by([&](const std::string&) { return table; });
  with_places(scene, [&] { return read_model(scene); });
  std::string lines;
  for (const Warning& warning : scene.warnings()) lines += warning.line + '\n';
  return lines;
}

const std::string rows = "\n0 0 1 0\n5 0 1 0\n";

TEST(Columns, ThatNobodyReadsAreWarnedOf) {
  EXPECT_EQ(warnings(run, "q creepage _comment _x" + rows), "");
  const std::string known =
      "known are q, t, v, creepage, force, omega, normal_load, half_width, peak_traction, "
      "friction, "
      "and a name that begins with _ is left out without a warning\n";
  EXPECT_EQ(warnings(run, "q creepage temperature torque" + rows),
            "load.file = run.tsv: columns that are not used: temperature, torque; " + known);
  EXPECT_EQ(warnings(run, "q creepage N _x" + rows),
            "load.file = run.tsv: columns that are not used: N; " + known);
}

// Of all names in which up to a third of the letters differ.
TEST(Columns, OfNearlyAKnownNameAreRefused) {
  const std::vector<std::pair<std::string, std::string>> meant{{"normal_laod", "normal_load"},
                                                               {"normalload", "normal_load"},
                                                               {"Normal_Load", "normal_load"},
                                                               {"FRICTION", "friction"},
                                                               {"fricton", "friction"},
                                                               {"half-width", "half_width"},
                                                               {"peak_tractoin", "peak_traction"},
                                                               {"Omega", "omega"},
                                                               {"forces", "force"}};
  for (const auto& [name, known] : meant) {
    const std::string told =
        message([&, &wrong = name] { warnings(run, "q creepage " + wrong + " _x" + rows); });
    EXPECT_EQ(told, "test:7: load.file = 'run.tsv': line 1: unknown column '" + name +
                        "' (did you mean '" + known +
                        "'?); one that is not to be read has a name that begins with _");
  }
}

// Where all columns are needed, a misspelt one is missing anyhow: tables of results are starts.
TEST(Columns, OfStartsAreFree) {
  const std::string start = steel +
                            "problem transient\nload { creepage 0.001 }\nmotion { distance 5 }\n"
                            "step { ratio 1 }\nstart { type file file start.tsv }\n";
  EXPECT_EQ(warnings(start, "x bound traction slip\n-5 0 0 0\n0 300 10 0\n5 0 0 0\n"), "");
}

TEST(Doubts, CreepagesAreSmall) {
  const std::string steady = steel + "problem steady\nload { creepage ";
  const std::string doubt =
      "creepages above 0.2 are not small against 1, as the theory has them, and errors are of "
      "their "
      "size where part of the contact sticks; 0.2 % is 0.002\n";
  EXPECT_EQ(warnings(steady + "0.2 }"), "");
  EXPECT_EQ(warnings(steady + "-0.25 }"), "load.creepage = -0.25: " + doubt);
  EXPECT_EQ(warnings(run, "q creepage _ __" + std::string("\n0 0 1 0\n3 -0.3 1 0\n5 0.1 0 0\n")),
            "creepage of load.file = -0.3: " + doubt);
  const std::string normalised =
      "material { shear_modulus 1 poisson_ratio 0 }\n"
      "contact { half_width 1 peak_traction 1 }\n"
      "kernel { type plane length 10 }\ngrid { elements 20 }\n"
      "problem steady\nload { creepage 0.9 }\n";
  EXPECT_EQ(warnings(normalised), "");
}

TEST(Doubts, RadiiAreInMillimetres) {
  const std::string table = "t v omega _\n0 10000 21.7 0\n1 10000 21.7 0\n";
  EXPECT_EQ(warnings(run, table), "");
  const std::string told = warnings(transient + "load { file run.tsv radius 0.46 }\n", table);
  EXPECT_EQ(told.find("load.radius = 0.46: less than ten half-widths, 50 mm"), 0U) << told;
  EXPECT_NE(told.find("creepage of load.file = 0.999"), std::string::npos) << told;
}

TEST(Doubts, AForceThatIsThereAtOnceIsToldFrom) {
  const std::string steps = "step { ratio 2 }\nmotion { distance 5 }\n";
  const std::string under_force = transient + steps + "load { force -1000 }\n";
  const std::string doubt =
      "from a start at rest, it is reached over the first step, of 1 mm; start.type cattaneo "
      "starts "
      "under it\n";
  EXPECT_EQ(warnings(under_force), "load.force = -1000: " + doubt);
  const std::string ratio = warnings(transient + steps + "load { force_ratio -0.5 }\n");
  EXPECT_EQ(ratio.find("force of load.force_ratio = -1178"), 0U) << ratio;
  EXPECT_EQ(warnings(transient + steps + "load { creepage 0.001 }\n"), "");
  EXPECT_EQ(warnings(transient + steps + "load { force 0 }\n"), "");
  EXPECT_EQ(warnings(steel + steps +
                     "problem transient\nstart { type cattaneo }\n"
                     "load { force -1000 }\n"),
            "");
  const std::string of_file = transient + "load { file run.tsv }\n";
  EXPECT_EQ(warnings(of_file, "q force\n0 0\n2 -500\n"), "");
  EXPECT_NE(warnings(of_file, "q force\n0 -500\n2 -500\n").find("force of load.file = -500: from"),
            std::string::npos);
}

TEST(Doubts, AreOfOneKindWhateverTheNumbers) {
  EXPECT_EQ(kind_of_warning("step.ratio = 0.1: safe from 0.7 on"),
            kind_of_warning("step.ratio = -1e-07: safe from 1.3 on"));
  EXPECT_NE(kind_of_warning("step.ratio = 0.1: safe"),
            kind_of_warning("grid.elements = 0.1: safe"));
}

}  // namespace
}  // namespace microslip
