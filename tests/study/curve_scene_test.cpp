// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of creepage and force of generated contacts: methods agree, and the curve begins with the
// slope that the response to a slow creepage has, which comes from other equations.
#include "microslip/experiments/curve_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "microslip/experiments/response_scene.hpp"
#include "microslip/support/format.hpp"
#include "scene_text.hpp"

namespace microslip::experiments::curve_scene_test {

void no_progress(std::size_t, std::size_t) {}

/// A contact without a load.
std::string generated(std::mt19937& random) {
  const auto number = [&](double least, double most) {
    return format_short(std::uniform_real_distribution(least, most)(random));
  };
  const bool plane = std::bernoulli_distribution(0.5)(random);
  return "problem steady\nmaterial { shear_modulus " + number(1e4, 1e5) + "\npoisson_ratio " +
         number(0, 0.5) + " }\ncontact { half_width " + number(1, 8) + "\npeak_traction " +
         number(50, 500) + "\nbound_polynomial \"1 " + number(-0.3, 0.3) + " " + number(-0.3, 0.3) +
         "\" }\ngrid { elements 20 }\nkernel { type " +
         (plane ? "plane\nlength " + number(20, 200) : "strip\nwidth " + number(10, 100)) + " }\n";
}

std::vector<Table> curve_of(const std::string& text, const std::string& settings = "") {
  Scene scene = scene_of(text + settings);
  const CurveScene read = read_curve(scene);
  scene.reject_unread();
  return curve_tables(read, no_progress);
}

double quantity(const Table& summary, const std::string& name) {
  return summary.latest({{"quantity", name}}, "value");
}

TEST(Curve, MethodsAgreeOnGeneratedContacts) {
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i) {
    const std::string contact = generated(random);
    const std::vector<Table> inverted = curve_of(contact, "curve { points 12 }");
    const std::vector<Table> collocated =
        curve_of(contact, "method chebyshev\ncurve { points 12 }");
    const double most = quantity(inverted[1], "full_sliding_force");
    for (std::size_t k = 0; k < 12; ++k) {
      const double creepage = inverted[0].number(k, "creepage");
      EXPECT_NEAR(collocated[0].number(k, "creepage") / (creepage + 1e-30), k > 0, 1e-7) << contact;
      EXPECT_NEAR(inverted[0].number(k, "force"), collocated[0].number(k, "force"), 1e-8 * most)
          << contact << k;
    }
    EXPECT_NEAR(inverted[0].number(11, "force") / -most, 1, 1e-12) << contact;
    EXPECT_LT(inverted[0].number(8, "force_ratio"), inverted[0].number(4, "force_ratio"));
  }
}

TEST(Curve, BeginsWithTheSlopeOfASlowCreepage) {
  std::mt19937 random(2);
  for (int i = 0; i < 10; ++i) {
    const std::string contact = generated(random);
    const double slope =
        quantity(curve_of(contact, "curve { points 2 }")[1], "slope_without_creepage");
    Scene scene = scene_of(contact + "load { force 0 }\nresponse { wavelengths 2 }");
    const std::vector<Table> response = response_tables(read_response(scene), no_progress);
    EXPECT_NEAR(slope / quantity(response[1], "steady_slope"), 1, 1e-7) << contact;
  }
}

TEST(Curve, FastsimHasItsSlopeAndItsFullSliding) {
  std::mt19937 random(3);
  const std::vector<Table> tables =
      curve_of(generated(random), "curve { beside fastsim\n points 1001 }");
  const Table& table = tables[0];
  const double most = quantity(tables[1], "full_sliding_force");
  for (std::size_t k = 0; k < table.rows(); ++k) {
    EXPECT_NEAR(table.number(k, "fastsim_force"), table.number(k, "force"), 0.15 * most) << k;
  }
  const double slope = quantity(tables[1], "slope_without_creepage");
  const double first = table.number(1, "fastsim_force") / table.number(1, "creepage");
  EXPECT_NEAR(first / slope, 1, 0.01);
}

}  // namespace microslip::experiments::curve_scene_test
