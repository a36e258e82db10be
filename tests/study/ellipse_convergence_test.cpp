// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/ellipse_convergence.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::ellipse_convergence_test {

std::vector<Table> found_with(const std::vector<std::string>& settings) {
  return tables_of("ellipse_convergence", read_ellipse_convergence, ellipse_convergence, settings);
}

TEST(EllipseConvergence, Verdicts) {
  const std::vector<Table> found =
      found_with({"ellipse.aspects=0.2", "ellipse.lines=0.1 10", "convergence.sizes=7 10 20",
                  "convergence.rectangles=7 10"});
  EXPECT_EQ(verdicts(found), std::vector<std::string>(11, "ours"));
}

// CONTACT's results are of other equations, so that they tell whether ours are right.
TEST(EllipseConvergence, LimitsAreThoseOfContact) {
  const std::vector<Table> found =
      found_with({"ellipse.aspects=1", "ellipse.lines=1", "convergence.sizes=5 6",
                  "convergence.rectangles=5 6", "convergence.reference=18"});
  const Table& limits = table_named(found, "limits");
  ASSERT_EQ(limits.rows(), 15U);
  for (std::size_t i = 0; i < limits.rows(); ++i) {
    EXPECT_NEAR(limits.number(i, "force"), limits.number(i, "contact_force"), 6e-3) << i;
    EXPECT_NEAR(limits.number(i, "moment"), limits.number(i, "contact_moment"), 6e-3) << i;
  }
}

TEST(EllipseConvergence, RefusesAReferenceThatIsOneOfTheSizes) {
  EXPECT_THROW(
      parameters_of("ellipse_convergence", read_ellipse_convergence, {"convergence.reference=20"}),
      std::invalid_argument);
}

}  // namespace microslip::experiments::ellipse_convergence_test
