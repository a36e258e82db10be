// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/carter.hpp"

#include <gtest/gtest.h>

#include "microslip/experiments/scene_tables.hpp"
#include "scene_text.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::carter_test {

constexpr Material material{1, 0.28};

std::vector<Table> tables_for(const std::string& basis) {
  return tables_of("carter", read_carter, carter, {"basis=" + basis});
}

// Thesis Fig. 1.1: small steps wiggle, c = 1 does not.
TEST(CarterStudy, SmallStepsWiggle) {
  const Table summary = tables_for("constant")[2];
  ASSERT_EQ(summary.name(), "summary");
  EXPECT_EQ(summary.number(0, "turning_points"), 1);
  EXPECT_EQ(summary.number(1, "turning_points"), 1);
  EXPECT_GE(summary.number(2, "turning_points"), 5);
  EXPECT_GE(summary.number(4, "turning_points"), 25);  // 29 of the 30 elements in adhesion
  EXPECT_NEAR(summary.number(0, "relative_force_error"), 0.0075, 0.0001);
}

// Thesis 6.2: linear functions reduce the wiggles, "but this is not enough by far".
TEST(CarterStudy, LinearFunctionsWiggleLater) {
  const Table constant = tables_for("constant")[2];
  const Table linear = tables_for("linear")[2];
  for (const std::size_t row : {2U, 3U, 4U}) {
    EXPECT_LT(linear.number(row, "turning_points"), constant.number(row, "turning_points"));
    EXPECT_LT(linear.number(row, "largest_error"), constant.number(row, "largest_error"));
  }
  EXPECT_GE(linear.number(4, "turning_points"), 25);
}

TEST(CarterStudy, HasARowForEveryNodeAndStep) {
  const std::vector<Table> tables = tables_for("constant");
  EXPECT_EQ(tables[0].rows(), 5U * 50);
  EXPECT_EQ(tables[2].rows(), 5U);
}

TEST(CarterStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables_for("constant")),
            (std::vector<std::string>{"reproduced", "reproduced"}));
}

TEST(SteadyScene, SummaryHoldsThePromisedRows) {
  const auto tables =
      scene_tables(SteadyProblem{.contact = {PlaneKernel(material, 200), HertzBound(1, 1)},
                                 .grid = Grid({.half_width = 1, .elements = 50}),
                                 .basis = constant_basis(),
                                 .method = Differences{},
                                 .load = PrescribedForce{-1}},
                   [](std::size_t, std::size_t) {});
  std::vector<std::string> quantities;
  for (std::size_t i = 0; i < tables[1].rows(); ++i) {
    quantities.push_back(std::get<std::string>(tables[1].at(i, "quantity")));
  }
  for (const char* promised : {"force", "creepage", "force_ratio", "adhesion_elements",
                               "slip_elements", "iterations", "dissipation"}) {
    EXPECT_NE(std::find(quantities.begin(), quantities.end(), promised), quantities.end())
        << promised;
  }
}

// Carter's solution is exact for one kernel and one bound alone.
TEST(CarterStudy, RefusesContactsThatAreNotCarters) {
  const std::string scene =
      "step { ratios 1 }\naccuracy { step_ratios 1 }\ncontact { half_width 1 peak_traction 1 }\n"
      "grid { elements 50 }\nload { creepage 0.576 }\n";
  const std::string steel = "material { shear_modulus 1 poisson_ratio 0.28 }\n";
  const auto refusal = [&](const std::string& kernel, const std::string& setting = "") {
    return message([&] {
      Scene read = scene_of(scene + kernel);
      if (!setting.empty()) read.set(setting);
      read_carter(read);
    });
  };
  const std::string plane = steel + "kernel { type plane length 200 }\n";
  EXPECT_EQ(refusal(plane), "");
  const std::string why = "as errors are differences to Carter's solution";
  EXPECT_EQ(refusal(steel + "kernel { type strip width 2 }\n"),
            "kernel.type = 'strip': expected plane without a layer, " + why);
  EXPECT_EQ(refusal(plane, "kernel.compliance=1"),
            "kernel.type = 'plane with a layer': expected plane without a layer, " + why);
  for (const char* setting : {"contact.bound_polynomial=1 0 -0.5", "contact.roughness=0.1"}) {
    EXPECT_EQ(refusal(plane, setting),
              "contact.bound_polynomial, contact.roughness: expected none, " + why);
  }
}

}  // namespace microslip::experiments::carter_test
