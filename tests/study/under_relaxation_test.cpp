// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/under_relaxation.hpp"

#include <gtest/gtest.h>

#include "microslip/experiments/profile.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::under_relaxation_test {

constexpr Material material{1, 0.28};

CattaneoToCarter rolling_on(Eigen::Index n, const Basis& basis = constant_basis()) {
  return {.kernel = PlaneKernel(material, 200),
          .bound = HertzBound(1, 1),
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = basis,
          .force = 0.64 * HertzBound(1, 1).total()};
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("under_relaxation", read_under_relaxation, under_relaxation,
                {"step.ratios=1 0.8 0.5 0.2 0.01", "reference.refinement=5",
                 "wiggles.relaxed_step_ratios=1 0.1 0.01 0.001 0.0001",
                 "wiggles.direct_step_ratios=1 0.1 0.01 0.001"});
  return all;
}

// The peak, the ridge at the bound and the valley between them, for every c.
TEST(UnderRelaxationStudy, RelaxedSolutionsKeepTheirExtrema) {
  const Table& summary = table_named(tables(), "summary");
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    if (std::get<std::string>(summary.at(i, "scheme")) == "relaxed") {
      EXPECT_EQ(summary.number(i, "turning_points"), 3) << summary.number(i, "step_ratio");
    } else if (summary.number(i, "step_ratio") < 0.1) {
      EXPECT_GT(summary.number(i, "turning_points"), 15);
    }
  }
}

// The full study makes the whole distance at c = 1e-5; here two elements at 1e-6, for both bases.
TEST(UnderRelaxationStudy, NoWigglesAtAMillionthOfAnElement) {
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    const CattaneoToCarter rolling = rolling_on(15, basis);
    const auto extrema = [&](double step_ratio) {
      const Eigen::VectorXd traction = rolling.rolled(Relaxed{1}, step_ratio, 2).state().traction;
      return turning_points(traction, 1e-9);
    };
    EXPECT_EQ(extrema(1e-6), extrema(1));
  }
}

// Numerical diffusion: the smaller the step, the less is left of the peak.
TEST(UnderRelaxationStudy, RelaxationSuppressesThePeakMoreTheSmallerTheStep) {
  const Table& summary = table_named(tables(), "summary");
  for (std::size_t i = 2; i < 10; ++i) {
    ASSERT_EQ(std::get<std::string>(summary.at(i, "scheme")), "relaxed");
    EXPECT_GT(summary.number(i, "error"), summary.number(i - 2, "error"));
    EXPECT_LT(summary.number(i, "total_variation"), summary.number(i - 2, "total_variation"));
  }
}

TEST(UnderRelaxationStudy, PartingShowsTheElementsThatDiffer) {
  const Table& parting = table_named(tables(), "parting");
  ASSERT_EQ(parting.rows(), 147U);
  int differing = 0;
  for (std::size_t i = 0; i < parting.rows(); ++i) {
    differing += parting.at(i, "relaxed_region") != parting.at(i, "relaxed_traction_region");
  }
  EXPECT_GE(differing, 1);
}

TEST(UnderRelaxationStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()),
            (std::vector<std::string>{"reproduced", "reproduced", "reproduced", "reproduced",
                                      "corrected", "reproduced", "corrected"}));
}

}  // namespace microslip::experiments::under_relaxation_test
