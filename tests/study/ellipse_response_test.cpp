// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/ellipse_response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study_tables.hpp"

namespace microslip::experiments::ellipse_response_test {

std::vector<Table> found_with(const std::vector<std::string>& settings) {
  return tables_of("ellipse_response", read_ellipse_response, ellipse_response, settings);
}

TEST(EllipseResponse, Verdicts) {
  const std::vector<Table> found =
      found_with({"ellipse.aspects=1 5", "convergence.rows=6 12", "convergence.reference=16",
                  "curve.points=30", "step.numbers=1 4"});
  const std::vector<std::string> all = verdicts(found);
  EXPECT_EQ(all, std::vector<std::string>(all.size(), "ours"));
}

// Two other methods have these values: 4.0814-.3716i and .682-1.062i.
TEST(EllipseResponse, HasTheCoefficientsOfACircle) {
  const std::vector<Table> found =
      found_with({"ellipse.aspects=1", "waves.lengths=2.5 100", "convergence.rows=4 5",
                  "convergence.reference=12", "curve.points=3", "step.elements=6", "step.numbers=1",
                  "step.ratios=2 1"});
  const Table& table = table_named(found, "coefficients");
  const auto expect = [&](double wavelength, const char* name, double real, double imaginary) {
    const std::vector<std::pair<std::string, Cell>> row = {{"wavelength", wavelength},
                                                           {"coefficient", name}};
    EXPECT_NEAR(table.latest(row, "real"), real, 1.3e-3) << name;
    EXPECT_NEAR(table.latest(row, "imaginary"), imaginary, 1.3e-3) << name;
  };
  expect(100, "C11", 4.0814, -.3716);
  expect(2.5, "C11", .0653, -.9431);
  expect(2.5, "C23", -.3006, -.1009);
  expect(2.5, "C33", .682, -1.062);
}

TEST(EllipseResponse, RefusesAReferenceThatIsOneOfTheRows) {
  EXPECT_THROW(
      parameters_of("ellipse_response", read_ellipse_response, {"convergence.reference=16"}),
      std::invalid_argument);
}

}  // namespace microslip::experiments::ellipse_response_test
