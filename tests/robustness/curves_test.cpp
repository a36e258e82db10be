// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of creepage and force by the built executable: Carter's closed form, curves of several
// contacts, tables for other programs, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "microslip/scene/table.hpp"
#include "robustness/executables.hpp"

namespace microslip::curves_test {

const std::string plane_scene = R"(problem steady
material { shear_modulus 82000
           poisson_ratio 0.28 }
contact { half_width 5
          peak_traction 300 }
kernel { type plane
         length 50 }
grid { elements 20 }
)";

const std::string ellipse_scene = R"(problem steady
material { shear_modulus 82000
           poisson_ratio 0.28 }
contact { half_width 6
          lateral_half_width 4
          peak_traction 300 }
grid { rows 7
       elements 9 }
load { spin 0.1 1/m }
)";

class Curves : public Executables {
 protected:
  Outcome curve(const std::string& options, const std::string& scene = plane_scene) const {
    return run_program("microslip", "curve", scene, options);
  }

  Table table_of(const std::string& name) const {
    return read_table(name, text_of(out() / (name + ".tsv"))).table;
  }

  static double number(const Table& table, std::size_t row, const std::string& column) {
    return std::stod(std::get<std::string>(table.at(row, column)));
  }

  /// Returns a quantity of a summary without a sweep.
  double quantity(const std::string& name) const {
    const Table summary = table_of("summary");
    for (std::size_t i = 0; i < summary.rows(); ++i) {
      if (std::get<std::string>(summary.at(i, "quantity")) == name) {
        return number(summary, i, "value");
      }
    }
    return NAN;
  }

  void expect_error(const std::string& options, const std::string& error,
                    const std::string& scene = plane_scene) const {
    const Outcome outcome = curve(options, scene);
    EXPECT_EQ(outcome.status, 1) << options;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(error), std::string::npos) << outcome.error;
    EXPECT_FALSE(fs::exists(out())) << options;
  }
};

/// |F| of Carter over full sliding, at a part of the creepage where all slides.
double carter(double part) { return part >= 1 ? 1 : part * (2 - part); }

TEST_F(Curves, AreCartersInPlaneStrainForEachHalfWidth) {
  for (const char* method : {"", " --set method=chebyshev"}) {
    const Outcome outcome = curve("--half-widths '3:2:7' --beside fastsim" + std::string(method));
    ASSERT_EQ(outcome.error, "");
    const Table table = table_of("curve");
    ASSERT_EQ(table.rows(), 3U * 51U);
    const double sliding = 2 * 0.72 / 82000 * 300;
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const double a = 3 + 2 * static_cast<double>(i / 51);
      EXPECT_EQ(number(table, i, "contact.half_width"), a);
      const double most = std::numbers::pi / 2 * a * 300;
      const double part = number(table, i, "creepage") / sliding;
      EXPECT_NEAR(number(table, i, "force"), -most * carter(part), 1e-10 * most) << i;
      EXPECT_NEAR(number(table, i, "force_ratio"), -carter(part), 1e-10) << i;
      const double xi = std::min(1.0, 2 * part / 3);
      EXPECT_NEAR(number(table, i, "fastsim_force"), -most * xi * (3 - xi * (3 - xi)), 1e-6 * most);
    }
    EXPECT_EQ(number(table, 0, "creepage"), 0);
    EXPECT_NEAR(number(table, 50, "creepage") / sliding, 1.21, 0.02);
    fs::remove_all(out());
  }
}

// Without slip the force is that of Carter, whatever the bound.
TEST_F(Curves, HaveASlopeWithoutCreepageThatNoTableChanges) {
  std::ofstream(folder_ / "bound.tsv") << "x bound\n-5 0\n-1 300\n0 20\n0.01 250\n5 0\n";
  const std::string set = " --set contact.peak_traction= --set contact.bound_file='" +
                          (folder_ / "bound.tsv").string() + "'";
  ASSERT_EQ(curve("--creepages '1e-6 1e-3'" + set).status, 0);
  EXPECT_NEAR(quantity("slope_without_creepage") / (-std::numbers::pi * 5 * 82000 / (2 * 0.72)), 1,
              1e-8);
}

TEST_F(Curves, BeginWithTheSlopeOfLinearTheory) {
  ASSERT_EQ(curve("--beside fastsim --points 2 --largest '0.5 %'").error, "");
  EXPECT_EQ(table_of("curve").rows(), 2U);
  EXPECT_EQ(number(table_of("curve"), 1, "creepage"), 0.005);
  const double slope = std::numbers::pi * 5 * 82000 / (2 * 0.72);
  EXPECT_NEAR(quantity("slope_without_creepage") / -slope, 1, 1e-7);
  EXPECT_NEAR(quantity("fastsim_flexibility") * slope / 50, 1, 1e-7);
  EXPECT_NEAR(quantity("fastsim_full_sliding_creepage") * slope / (3 * 750 * std::numbers::pi), 1,
              1e-7);
}

TEST_F(Curves, TakeTheCreepagesThatAreGiven) {
  ASSERT_EQ(curve("--creepages '-1e-3:5e-4:1e-3 0.2%'").error, "");
  const Table table = table_of("curve");
  ASSERT_EQ(table.rows(), 6U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(number(table, i, "force"), -number(table, 4 - i, "force"), 1e-12);
  }
  EXPECT_EQ(number(table, 2, "force"), 0);
  EXPECT_EQ(number(table, 5, "creepage"), 0.002);
}

// The load has no part in it, even if it is more than full sliding of one of the contacts.
TEST_F(Curves, NeedNoLoadAndTakeNoNoticeOfOne) {
  ASSERT_EQ(curve("--points 5").status, 0);
  const Table without = table_of("curve");
  for (const char* load : {"load.force=-1e5", "load.creepage=1", "load.stick_ratio=0.5"}) {
    ASSERT_EQ(curve("--points 5 --set " + std::string(load)).error, "") << load;
    const Table with = table_of("curve");
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(with.at(i, "force"), without.at(i, "force"));
  }
  fs::remove_all(out());
  expect_error("--set load.forse=1", "unknown key 'load.forse'");
}

TEST_F(Curves, OfTransientsAreThoseOfTheirContact) {
  ASSERT_EQ(curve("--points 4 --largest 1").status, 0);
  ASSERT_EQ(curve("--points 4 --largest 1", good_transient).error, "");
  const Table rolled = table_of("curve");
  ASSERT_EQ(curve("--points 4 --largest 1", good_scene).error, "");
  const Table steady = table_of("curve");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(rolled.at(i, "force"), steady.at(i, "force")) << i;
}

TEST_F(Curves, KnowTheTractionCoefficientWhereTheyKnowTheLoad) {
  const std::string hertz =
      "--set contact.half_width= --set contact.peak_traction= --set contact.radius_1=460 "
      "--set contact.friction=0.3 --set contact.normal_load=2000 --points 3 --largest 0.1 ";
  ASSERT_EQ(curve(hertz + "--set 'sweep.contact.normal_load=2000 4000'").error, "");
  const Table table = table_of("curve");
  ASSERT_EQ(table.rows(), 6U);
  EXPECT_NEAR(number(table, 2, "traction_coefficient"), -0.3, 1e-12);
  EXPECT_NEAR(number(table, 5, "force"), -0.3 * 4000, 1e-9);
}

TEST_F(Curves, AreCommaSeparatedForOtherPrograms) {
  ASSERT_EQ(curve("--format csv --creepages '0 0.01' --half-widths 5").error, "");
  std::istringstream csv(text_of(out() / "curve.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "contact.half_width [mm],creepage,force [N/mm],force_ratio,method");
  std::getline(csv, line);
  EXPECT_EQ(line, "5,0,0,0,inversion");
  std::getline(csv, line);
  EXPECT_EQ(line.substr(0, 7), "5,0.01,");
  EXPECT_NEAR(std::stod(line.substr(7)), -750 * std::numbers::pi, 1e-9);
  EXPECT_FALSE(std::getline(csv, line));
  EXPECT_NE(text_of(out() / "provenance.txt").find("curve.csv"), std::string::npos);
  ASSERT_EQ(curve("--creepages '0 0.01'").status, 0);
  EXPECT_FALSE(fs::exists(out() / "curve.csv")) << "of the run before";
}

TEST_F(Curves, AreDrawnWithFastsimAndTheExactSolution) {
  ASSERT_EQ(curve("--half-widths '3 5' --beside fastsim --points 21").status, 0);
  const Outcome plot =
      run_command("cd '" + folder_.string() + "' && " MICROSLIP_BIN "/microslip plot out");
  EXPECT_EQ(plot.output, "drew out.svg\n") << plot.error;
  const std::string figure = text_of(folder_ / "out.svg");
  for (const char* text : {"contact.half_width = 3 mm", "FASTSIM", "Carter, exact", "creepage"}) {
    EXPECT_NE(figure.find(text), std::string::npos) << text;
  }
}

TEST_F(Curves, OfAnEllipseAreDrawnWithLaws) {
  ASSERT_EQ(curve("--along lateral_creepage --beside 'fastsim polach' --points 9 "
                  "--set 'sweep.load.spin=0 0.1 0.3 1/m'",
                  ellipse_scene)
                .error,
            "");
  const Table table = table_of("curve");
  EXPECT_EQ(table.rows(), 3U * 9);
  EXPECT_LT(number(table, 9, "lateral_creepage"), 0);
  EXPECT_EQ(number(table, 0, "lateral_creepage"), number(table, 9, "lateral_creepage"));
  EXPECT_NEAR(number(table, 26, "spin"), 3e-4, 1e-12);
  const Outcome plot =
      run_command("cd '" + folder_.string() + "' && " MICROSLIP_BIN "/microslip plot out");
  EXPECT_EQ(plot.output, "drew out.svg\n") << plot.error;
  const std::string figure = text_of(folder_ / "out.svg");
  for (const char* text : {"load.spin = 0.0003 1/mm", "FASTSIM: off by up to",
                           "Polach: off by up to", "lateral_creepage", "lateral_force [N]"}) {
    EXPECT_NE(figure.find(text), std::string::npos) << text;
  }
}

TEST_F(Curves, BadInputOfAnEllipse) {
  const auto expect = [&](const std::string& options, const std::string& error) {
    expect_error(options, error, ellipse_scene);
  };
  const Outcome large = curve("--along spin --spins '0 0.2 0.5' --set load.spin=", ellipse_scene);
  EXPECT_NE(large.error.find("curve.spins = 0.5: the slip by this spin"), std::string::npos)
      << large.error;
  fs::remove_all(out());
  expect("--along yaw", "curve.along = 'yaw': expected creepage or lateral_creepage or spin");
  expect("--along spin --creepages '0 1'", "'curve.creepages' has no role here");
  expect("--spins '0 1'", "'curve.spins' has no role here: it is for microslip curve with");
  expect("--along spin --largest 0.1", "'curve.largest' has no role here");
  expect("--along spin --spins '0 2 1 1/m'", "curve.spins = 0.001: expected numbers in rising");
  expect("--beside 'fastsim polak'", "curve.beside = 'polak': expected nothing or fastsim");
  expect("--kalker-factor 0.6", "it is for microslip curve with curve.beside");
  expect("--beside polach --kalker-factor 1.1", "curve.kalker_factor = 1.1: expected a number");
  expect("--set problem=transient", "problem = 'transient': expected steady for a curve of an");
  expect("--set load.lateral_force=1e6", "load.lateral_force = 1e+06: expected less than full");
  expect("--along lateral_creepage --set 'sweep.load.lateral_creepage=0 1e-3'",
         "key 'sweep.load.lateral_creepage': expected another key, as the curves vary the "
         "lateral_creepage (curve.along) and would all be equal");
  expect("--along spin --set 'sweep.load.spin_moment=0 1'", "key 'sweep.load.spin_moment': exp");
  expect("--set 'sweep.load.force_ratio=0 0.1'", "key 'sweep.load.force_ratio': expected another");
  expect_error("--set 'sweep.load.creepage=0 0.1'", "key 'sweep.load.creepage': expected another");
  expect_error("--beside polach",
               "curve.beside = 'polach': expected nothing or fastsim for a line");
  expect_error("--along spin", "'curve.along' has no role here: it is for ellipses");
}

TEST_F(Curves, BadInput) {
  expect_error("--points 1", "curve.points = 1: expected a whole number 2 ... 10 000");
  expect_error("--points 2.5", "curve.points = 2.5: expected a whole number");
  expect_error("--largest 0", "curve.largest = 0: expected a number > 0");
  expect_error("--creepages '0 0.01 0.005'", "curve.creepages = 0.005: expected numbers in rising");
  expect_error("--creepages '0:0:1'", "curve.creepages = '0:0:1': expected first:step:last");
  expect_error("--creepages fast", "curve.creepages = 'fast': expected finite numbers");
  expect_error("--creepages 0 --beside fastsim", "curve.creepages = '0': expected");
  expect_error("--creepages 1 --points 3",
               "expected only one of 'curve.creepages' and 'curve.points'");
  expect_error("--beside carter", "curve.beside = 'carter': expected nothing or fastsim");
  expect_error("--format xls", "--format 'xls': expected tsv or csv");
  expect_error("--half-widths '3 -1'", "case 2 of 2 (contact.half_width = -1): contact.half_width");
  expect_error("--set 'sweep.kernel.lenght=1 2'", "unknown key 'kernel.lenght'");
  expect_error("--set target_error=1e-3", "target_error: expected a scene without it");
  expect_error(
      "--beside fastsim --set material.dundurs_beta=0.1 --set contact.friction=0.3 "
      "--set leading_edge=calibrated",
      "curve.beside = 'fastsim': expected nothing for bodies of different material");
  const Outcome missing = curve(
      "--set method=chebyshev --set kernel.length= --set kernel.type=strip "
      "--set kernel.width=0.1 --creepages 1e-3");
  EXPECT_EQ(missing.status, 2) << missing.error;
  EXPECT_FALSE(fs::exists(out()));
  const Outcome elsewhere = run_program("microslip", "", good_scene, "--set curve.points=3");
  EXPECT_NE(elsewhere.error.find("key 'curve.points' has no role here: it is for microslip curve"),
            std::string::npos)
      << elsewhere.error;
}

// Bodies of different material have no symmetry, and a force without creepage.
TEST_F(Curves, OfDifferentMaterialBeginBelowZero) {
  ASSERT_EQ(curve("--points 5 --set material.dundurs_beta=0.2 --set contact.friction=0.3 "
                  "--set leading_edge=calibrated --set grid.elements=50")
                .error,
            "");
  const Table table = table_of("curve");
  EXPECT_EQ(number(table, 0, "creepage"), -number(table, 4, "creepage"));
  EXPECT_EQ(number(table, 2, "creepage"), 0);
  EXPECT_GT(std::abs(number(table, 2, "force")), 1);
}

}  // namespace microslip::curves_test
