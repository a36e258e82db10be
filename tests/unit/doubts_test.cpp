// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes warn of columns that nobody reads, creepages and radii that are mistakes of units, and
// forces that are there at once.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "microslip/reference/carter.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::doubts_test {

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

// This holds for all names in which up to a third of the letters differ.
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

const std::string ellipse =
    "material { shear_modulus 82 GPa poisson_ratio 0.28 }\n"
    "contact { half_width 5 mm lateral_half_width 4 mm normal_load 80 kN friction 0.3 }\n"
    "grid { rows 4 elements 4 }\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// Gigapascals or pascals without a unit; normalised contacts have moduli about 1.
TEST(Doubts, ModuliAreInNewtonsPerSquareMillimetre) {
  const std::string force = "problem steady\nload { force -100 }\n";
  for (const std::string& text : {steel + force, ellipse + force}) {
    EXPECT_EQ(warnings(text), "");
    for (const char* modulus : {"80", "10", "101"}) {
      const std::string told = warnings(with(text, "82 GPa", modulus));
      EXPECT_NE(told.find("of the shear modulus, " + std::string(modulus) + " N/mm^2, and strains"),
                std::string::npos)
          << told;
    }
    EXPECT_EQ(warnings(with(text, "82 GPa", "9.9")), "");
    EXPECT_EQ(warnings(with(text, "82 GPa", "8.2e10 Pa")), "");
    EXPECT_EQ(warnings(with(text, "82 GPa", "8.2e10")),
              "material.shear_modulus = 8.2e10: a shear modulus of 8.2e+10 N/mm^2, which is more "
              "than that of any solid; moduli without a unit are in N/mm^2\n");
    const std::string young = with(text, "shear_modulus 82 GPa", "youngs_modulus 2.1e11");
    EXPECT_EQ(warnings(young).find("material.youngs_modulus = 2.1e11: a shear modulus of 8.2e+10"),
              0U);
  }
}

/// Warnings that begin with a text, and not those of long steps.
std::string of(const std::string& begin, const std::string& lines) {
  const std::size_t at = lines.find(begin);
  return at == std::string::npos ? "" : lines.substr(at, lines.find('\n', at) + 1 - at);
}

TEST(Doubts, LoadsOfRowsAreThoseOfTheScene) {
  const std::string of_ellipse =
      ellipse + "problem transient\nstart { type rest }\nload { file run.tsv }\n";
  const std::string of_line = with(with(transient, "half_width 5 mm peak_traction 300 MPa",
                                        "normal_load 80000 radius_1 460 friction 0.3"),
                                   "length 100 mm", "length 1000 mm") +
                              "load { file run.tsv }\n";
  const auto rows_of = [](const std::string& one, const std::string& two) {
    return "q creepage normal_load\n0 0 0\n5 0 " + one + "\n10 0 " + two + "\n";
  };
  for (const auto& [text, unit] : {std::pair(of_ellipse, "N"), std::pair(of_line, "N/mm")}) {
    const std::string scene = std::string("80000 ") + unit + " of contact.normal_load";
    EXPECT_EQ(of("normal_load", warnings(text, rows_of("80", "70"))),
              "normal_load of load.file = 80: the largest of all rows, beside " + scene +
                  "; a column without a unit in its name is in " + unit + '\n');
    EXPECT_NE(of("normal_load", warnings(text, rows_of("800", "0"))), "");
    EXPECT_EQ(of("normal_load", warnings(text, rows_of("80", "801"))), "");
    EXPECT_EQ(of("normal_load", warnings(text, rows_of("0", "0"))), "");
    EXPECT_EQ(of("normal_load", warnings(text, rows_of("8e6", "7.9e6"))), "");
  }
  EXPECT_NE(warnings(of_ellipse, rows_of("8e6", "9e6")).find("8e+06: the least of all rows"),
            std::string::npos);
}

TEST(Doubts, SpeedsAreInMillimetresPerSecond) {
  const auto table = [](const std::string& v) {
    return "t v" + v + " creepage\n0 27.8 0\n0.1 27.8 0.001\n";
  };
  const std::string of_ellipse =
      ellipse + "problem transient\nstart { type rest }\nload { file run.tsv }\n";
  for (const std::string& text : {with(run, " radius 460 mm", ""), of_ellipse}) {
    EXPECT_EQ(of("v of", warnings(text, table(""))),
              "v of load.file = 27.8: the bodies roll 2.8 mm in all, and the half-width is 5 mm; a "
              "column without a unit in its name is in mm/s\n");
    EXPECT_EQ(of("v of", warnings(text, table("[m/s]"))), "");
    EXPECT_EQ(of("v of", warnings(text, "q creepage\n0 0\n1 0.001\n")), "");
  }
}

TEST(Doubts, BodiesTurnOnAShortWay) {
  const std::string of_ellipse =
      ellipse + "problem transient\nstart { type rest }\nload { file run.tsv }\n";
  const std::string behind =
      ": the shortest way, in mm, before the bodies turn again or stop; they turn ";
  for (const std::string& text : {with(run, " radius 460 mm", ""), of_ellipse}) {
    const auto warned = [&](const std::string& places) {
      std::string table = "q creepage\n";
      for (const char place : places) table += place == ' ' ? " 0.001\n" : std::string(1, place);
      return of("q of", warnings(text, table));
    };
    EXPECT_EQ(warned("0 1 2 1.96 3 "), "q of load.file = 0.04" + behind +
                                           "2 times, and places that were measured want "
                                           "smoothing\n");
    EXPECT_EQ(warned("0 -1 -2 -1.96 "), "q of load.file = 0.04" + behind +
                                            "once, and places that were measured want "
                                            "smoothing\n");
    EXPECT_EQ(warned("0 1 2 1.94 3 "), "");
    EXPECT_EQ(warned("0 0.01 0.02 "), "");
  }
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

TEST(Doubts, NumbersOfWarningsAreShort) {
  EXPECT_EQ(warnings(run, "t v omega _\n0 20000 0.3333333 0\n0.001 20000 0.3333333 0\n")
                .find("creepage of load.file = 0.992333: "),
            0U);
}

// As vehicle codes and spreadsheets write them.
TEST(Columns, MayBeSeparatedByCommasOrSemicolons) {
  const std::vector<std::string> tables{
      "q [m]\tcreepage [%]\n0\t0.1\n0.005\t0.2\n", "q [m],creepage [%]\n0,0.1\n0.005,0.2\n",
      "q[m] , creepage [ % ]\n 0 , 0.1\n\n# x, y, z\n0.005, 0.2\n",
      "\"q [m]\";\"creepage [%]\"\n0;0.1\n0.005;\"0.2\"\n",
      ",creepage [%],_note,q [m]\n0,0.1,x y,0\n1,0.2,,0.005\n"};
  for (const std::string& table : tables) {
    Scene scene = scene_of(run);
    scene.set("load.radius=");
    scene.read_files_by([&](const std::string&) { return table; });
    const Model model = read_model(scene);
    const LoadHistory& loads = std::get<TransientScene>(model).loads;
    EXPECT_EQ(loads.distance(), 5) << table;
    EXPECT_EQ(std::get<PrescribedCreepage>(loads.at(5)).value, 0.002) << table;
    EXPECT_TRUE(scene.warnings().empty()) << table;
  }
  EXPECT_EQ(message([] { warnings(run, "q;creepage;_\n0;0,1;0\n1;0,2;0\n"); }), "");
  EXPECT_EQ(message([] { warnings(run, "q,creepage\n0,1,2\n1,2\n"); }),
            "test:7: load.file = 'run.tsv': line 2: expected 2 values, found 3");
}

// The oracle is Carter's closed form. Where nothing is warned of, errors are those that
// docs/scenes.md promises.
TEST(Doubts, DifferencesNearFullSliding) {
  std::mt19937 random(1);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution(from, to)(random);
  };
  const std::array bases{std::pair{"constant", 11}, std::pair{"linear", 21},
                         std::pair{"quadratic", 51}};
  int warned = 0, wrong = 0;
  for (int i = 0; i < 600; ++i) {
    const double ratio = (i % 2 == 0 ? 1 : -1) * (1 - std::pow(10, uniform(-9, 0)));
    const auto& [basis, least] = bases[static_cast<std::size_t>(i) % 3];
    Scene scene = scene_of(fmt::format(
        "problem steady\nmaterial {{ shear_modulus 1 poisson_ratio 0.28 }}\n"
        "contact {{ half_width 1 peak_traction 1 }}\nkernel {{ type plane length 200 }}\n"
        "leading_edge {}\nbasis {}\nstep {{ ratio {} }}\ngrid {{ elements {} leading_offset {} "
        "trailing_offset {} }}\nload {{ force_ratio {} }}\n",
        i % 4 == 0 ? "known_edge" : "standard", basis, uniform(0.7, 1.5),
        static_cast<int>(least * std::pow(10, uniform(0, 1))) | 1, uniform(0.01, 1), uniform(0, 1),
        ratio));
    const auto problem = std::get<SteadyProblem>(read_model(scene));
    const double exact = Carter::from_force(problem.contact.kernel.material(),
                                            std::get<HertzBound>(problem.contact.bound),
                                            std::get<PrescribedForce>(problem.load).value)
                             .creepage();
    double error = 0;
    try {
      error = std::abs(solve_steady(problem).creepage / exact - 1);
    } catch (const std::invalid_argument&) {
      EXPECT_GT(std::abs(ratio), 0.9) << "the bound of the nodes is less than the force";
      continue;
    }
    if (scene.warnings().empty()) {
      EXPECT_LT(error, 0.1) << basis << ' ' << problem.grid.size() << ' ' << ratio;
    } else {
      ++warned;
      if (error > 0.1) ++wrong;
    }
  }
  EXPECT_GT(wrong, 20);
  EXPECT_LT(warned, 480);
}

TEST(Doubts, FewElementsInTransients) {
  const std::string rolls = transient + "step { ratio 1 }\nmotion { distance 5 }\n";
  const auto of = [&](const std::string& scheme, const std::string& set) {
    std::string text = rolls + "load { creepage 0.001 }\n";
    text.replace(text.find("step { "), 7, "step { scheme " + scheme + " ");
    Scene scene = scene_of(text);
    scene.set("grid.elements=" + set);
    read_model(scene);
    return scene.warnings().empty() ? "" : scene.warnings().front().line;
  };
  const std::string doubt =
      "this scheme is safe from 11 on; step.scheme remembered is safe for any";
  for (const char* scheme : {"direct", "relaxed", "relaxed_traction", "fractional"}) {
    EXPECT_EQ(of(scheme, "9"), "grid.elements = 9: " + doubt) << scheme;
    EXPECT_EQ(of(scheme, "11"), "") << scheme;
  }
  EXPECT_EQ(of("remembered", "4"), "");
}

}  // namespace microslip::doubts_test
