// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/kalker_coefficients.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "microslip/experiments/standard_patch.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::kalker_coefficients_test {

constexpr std::array<const char*, 4> names{"C11", "C22", "C23", "C33"};

double coefficient(const Table& table, double aspect, double nu, const std::string& name) {
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.number(i, "aspect") == aspect && table.number(i, "poisson_ratio") == nu &&
        std::get<std::string>(table.at(i, "coefficient")) == name) {
      return table.number(i, "value");
    }
  }
  throw std::logic_error("no such row");
}

// Galin's theorem: polynomials over a root weight, which share no code with rows of cells. Errors
// are at most 7e-5, at a/b = 0.2 with nu = 1/2; without nu = 1/2 at most 2e-5.
struct Galin {
  double ratio, nu;
  std::array<double, 4> coefficients;
};
constexpr Galin galin[] = {{0.2, 0, {2.591418, 2.591418, 0.483502, 3.471423}},
                           {0.2, 0.25, {3.375090, 2.632570, 0.602699, 4.295410}},
                           {0.2, 0.5, {4.819320, 2.663625, 0.806318, 5.695457}},
                           {1, 0, {3.395306, 3.395306, 1.333333, 1.207220}},
                           {1, 0.25, {4.112819, 3.668295, 1.466109, 1.184303}},
                           {1, 0.5, {5.204178, 3.981143, 1.630958, 1.158633}},
                           {5, 0, {6.997687, 6.997687, 5.718175, 0.833802}},
                           {5, 0.25, {7.811862, 8.190043, 6.637253, 0.604497}},
                           {5, 0.5, {8.837848, 9.868277, 7.901937, 0.342003}}};

TEST(KalkerCoefficients, AreThoseOfGalinsTheorem) {
  const std::vector<Table> found =
      tables_of("kalker_coefficients", read_kalker_coefficients, kalker_coefficients,
                {"ellipse.aspects=0.2 1 5", "ellipse.poisson_ratios=0 0.25 0.5",
                 "ellipse.elements=18", "convergence.aspects=1", "convergence.sizes=5 7",
                 "convergence.rectangles=5 7", "convergence.reference=10"});
  const Table& table = table_named(found, "coefficients");
  for (const Galin& one : galin) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      const double value = coefficient(table, one.ratio, one.nu, names[k]);
      const double accuracy = k < 2 ? 1e-4 : 1e-3;
      EXPECT_NEAR(value / one.coefficients[k], 1, accuracy)
          << names[k] << " at a/b = " << one.ratio << ", nu = " << one.nu;
    }
  }
}

// CONTACT v25.2, T = 3, N = 20, nu = 0.28, nothing slips: C11, C22, C23, C32 and C33 to ten digits.
TEST(KalkerCoefficients, TheStandardSchemeIsContacts) {
  const StandardPatch patch = standard_patch(1, 20, 0.28);
  EXPECT_EQ(patch.cells, 316);
  EXPECT_NEAR(-patch.linear(0, 0), 4.30558615, 5e-9);
  EXPECT_NEAR(-patch.linear(1, 1), 3.7914249172, 1e-8);
  EXPECT_NEAR(-patch.linear(1, 2), 1.5134575703, 1e-8);
  EXPECT_NEAR(patch.linear(2, 1), 1.4502671536, 1e-8);
  EXPECT_NEAR(-patch.linear(2, 2), 1.2679622657, 1e-8);
}

// Errors against one of the sizes would be none, and have no order.
TEST(KalkerCoefficients, RefusesAReferenceThatIsOneOfTheSizes) {
  try {
    parameters_of("kalker_coefficients", read_kalker_coefficients, {"convergence.reference=20"});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "convergence.reference = 20: expected a whole number 10 ... 40; above "
                 "convergence.sizes");
  }
}

TEST(KalkerCoefficients, Verdicts) {
  const std::vector<Table> found = tables_of(
      "kalker_coefficients", read_kalker_coefficients, kalker_coefficients,
      {"ellipse.aspects=0.1 0.2 0.5 0.7 0.8 0.9 1 1.25 2 5 10", "ellipse.poisson_ratios=0 0.5",
       "ellipse.elements=13", "convergence.rectangles=14 28"});
  EXPECT_EQ(verdicts(found), std::vector<std::string>(7, "ours"));
}

}  // namespace microslip::experiments::kalker_coefficients_test
