// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/ellipse_wiggles.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::ellipse_wiggles_test {

std::vector<Table> found_with(const std::vector<std::string>& settings) {
  return tables_of("ellipse_wiggles", read_ellipse_wiggles, ellipse_wiggles, settings);
}

TEST(EllipseWiggles, Verdicts) {
  const std::vector<Table> found = found_with(
      {"step.ratios=1 0.1", "step.force_step_ratios=1 0.5", "step.spin_step_ratios=1 0.5",
       "rolling.distances=0.5 1.5 3", "rolling.shown=0.5", "map.rows=5", "map.distances=1"});
  const Table& claims = table_named(found, "claims");
  for (std::size_t i = 0; i < claims.rows(); ++i) {
    EXPECT_NE(std::get<std::string>(claims.at(i, "verdict")), "refuted")
        << std::get<std::string>(claims.at(i, "claim")) << claims.number(i, "measured_value");
  }
}

// CONTACT's tractions are in the study as data; ours have the same waves.
TEST(EllipseWiggles, TheStandardSchemeHasTheWavesOfContact) {
  const std::vector<Table> found =
      found_with({"step.ratios=1", "step.force_step_ratios=1 0.5", "step.spin_step_ratios=1",
                  "grid.rows=5", "reference.rows=7", "reference.elements=14",
                  "rolling.distances=1 1.5", "map.rows=5", "map.distances=1"});
  const Table& table = table_named(found, "wiggles");
  for (const double c : {1.0, 0.5}) {
    const auto of = [&](const char* scheme, const char* column) {
      return table.latest(
          {{"load", "force"}, {"scheme", scheme}, {"step_ratio", c}, {"distance", 1.5}}, column);
    };
    EXPECT_NEAR(of("direct", "wave"), of("contact", "wave"), 1e-5) << c;
    EXPECT_NEAR(of("direct", "creepage"), of("contact", "creepage"), 1e-5) << c;
  }
}

TEST(EllipseWiggles, RefusesToShowADistanceThatIsNotThere) {
  EXPECT_THROW(parameters_of("ellipse_wiggles", read_ellipse_wiggles, {"rolling.shown=0.7"}),
               std::invalid_argument);
}

}  // namespace microslip::experiments::ellipse_wiggles_test
