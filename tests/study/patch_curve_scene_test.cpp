// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of resultants over a motion of generated ellipses: each point is the solution of the scene
// with this motion, and curves begin with Kalker's coefficients.
#include "microslip/experiments/patch_curve_scene.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "microslip/experiments/scene_tables.hpp"
#include "microslip/support/format.hpp"
#include "scene_text.hpp"

namespace microslip::experiments::patch_curve_scene_test {

void no_progress(std::size_t, std::size_t) {}

constexpr std::array motions{"creepage", "lateral_creepage", "spin"};

std::string generated(std::mt19937& random) {
  const auto number = [&](double least, double most) {
    return format_short(std::uniform_real_distribution(least, most)(random));
  };
  return "problem steady\nmaterial { shear_modulus 80000\npoisson_ratio " + number(0, 0.5) +
         " }\ncontact { half_width " + number(3, 8) + "\nlateral_half_width " + number(3, 8) +
         "\npeak_traction " + number(100, 500) + " }\ngrid { rows 8\nelements 9 }\n";
}

std::vector<Table> curve_of(const std::string& text) {
  Scene scene = scene_of(text);
  const PatchCurveScene read = read_patch_curve(scene);
  scene.reject_unread();
  return curve_tables(read, no_progress);
}

double quantity(const Table& summary, const std::string& name) {
  return summary.latest({{"quantity", name}}, "value");
}

TEST(PatchCurve, HasTheSolutionOfItsSceneAtEachPoint) {
  std::mt19937 random(1);
  for (int i = 0; i < 12; ++i) {
    const std::string contact = generated(random);
    const std::string along = motions.at(static_cast<std::size_t>(i) % 3);
    const std::string load = "load { creepage 0.0004\nlateral_creepage -0.0007\nspin 0.0001 }\n";
    const Table curve = curve_of(contact + load + "curve { points 7\nalong " + along + " }")[0];
    for (std::size_t k = 1; k < curve.rows(); k += 2) {
      Scene scene = scene_of(contact + load);
      scene.set("load." + along + "=" + format_short(curve.number(k, along)));
      const Table alone = scene_tables(read_steady_patch(scene), no_progress).back();
      const double full = quantity(alone, "full_sliding_force");
      for (const char* name : {"force", "lateral_force"}) {
        EXPECT_NEAR(curve.number(k, name), quantity(alone, name), 1e-6 * full) << contact << along;
      }
      EXPECT_NEAR(curve.number(k, "spin_moment"), quantity(alone, "spin_moment"), 1e-5 * full);
    }
  }
}

TEST(PatchCurve, HoldsResultantsOfOtherComponents) {
  std::mt19937 random(2);
  const Table curve =
      curve_of(generated(random) + "load { lateral_force_ratio 0.3 }\ncurve { points 6 }")[0];
  for (std::size_t k = 0; k < curve.rows(); ++k) {
    EXPECT_NEAR(curve.number(k, "lateral_force") / curve.number(0, "lateral_force"), 1, 1e-9);
    if (k > 0) {
      EXPECT_LT(curve.number(k, "force"), curve.number(k - 1, "force") + 1e-9);
      EXPECT_LT(curve.number(k, "lateral_creepage"), 0);
    }
  }
}

TEST(PatchCurve, BeginsWithKalkersCoefficientsAndEndsInFullSliding) {
  std::mt19937 random(3);
  for (int i = 0; i < 6; ++i) {
    const std::string contact = generated(random);
    const bool lateral = i % 2 == 1;
    const std::string along = motions.at(lateral);
    const std::vector<Table> tables =
        curve_of(contact + "curve { points 2001\nlargest 1e-5\nalong " + along + " }");
    const double force = tables[0].number(1, lateral ? "lateral_force" : "force");
    const double a = quantity(tables[1], "half_width"),
                 b = quantity(tables[1], "lateral_half_width");
    const double linear =
        80000 * a * b * quantity(tables[1], lateral ? "c22" : "c11") * tables[0].number(1, along);
    EXPECT_NEAR(force / -linear, 1, 1e-4) << contact;
    const Table all = curve_of(contact + "curve { points 9\nalong " + along + " }")[0];
    EXPECT_NEAR(all.number(8, "force_ratio"), 1, 1e-3) << contact;
    EXPECT_LT(all.number(4, "force_ratio"), 0.9999) << contact;
  }
}

TEST(PatchCurve, HasBothSidesWhereThereIsNoSymmetry) {
  std::mt19937 random(4);
  const std::string contact = generated(random);
  const auto first = [&](const std::string& load, const std::string& along) {
    return curve_of(contact + "load { " + load + " }\ncurve { points 5\nalong " + along + " }")[0]
        .number(0, along);
  };
  EXPECT_EQ(first("spin 1e-4", "creepage"), 0);
  EXPECT_EQ(first("creepage 1e-4", "lateral_creepage"), 0);
  EXPECT_LT(first("spin 1e-4", "lateral_creepage"), 0);
  EXPECT_LT(first("lateral_force_ratio 0.1", "spin"), 0);
  // As one of a family over the other motion.
  EXPECT_EQ(first("spin 0", "lateral_creepage"), first("spin 1e-4", "lateral_creepage"));
  EXPECT_EQ(first("lateral_creepage 0", "spin"), first("lateral_creepage 1e-4", "spin"));
}

TEST(PatchCurve, HasLawsWithinWhatIsKnownOfThem) {
  std::mt19937 random(5);
  for (int i = 0; i < 4; ++i) {
    const Table summary = curve_of(generated(random) +
                                   "curve { points 21\nbeside \"fastsim fastsim_one "
                                   "vermeulen_johnson polach\" }")[1];
    for (const char* law : {"fastsim", "fastsim_one", "vermeulen_johnson", "polach"}) {
      const double error = quantity(summary, std::string(law) + "_error");
      EXPECT_LT(error, 0.09) << law;
      EXPECT_GT(error, 0.005) << law;
    }
  }
}

TEST(PatchCurve, WarnsOfFewElementsUnderStrongSpin) {
  std::mt19937 random(6);
  const std::vector<Table> tables =
      curve_of(generated(random) + "curve { spins \"0.001 0.005 0.02\"\nalong spin }");
  EXPECT_GT(quantity(tables[1], "change"), 0.03);
  const auto& summary = tables[1];
  EXPECT_NE(std::get<std::string>(summary.at(summary.rows() - 1, "value")), "none");
}

}  // namespace microslip::experiments::patch_curve_scene_test
