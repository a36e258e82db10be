// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/frequency_response.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "microslip/rolling/schemes.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::frequency_response_test {

using Complex = std::complex<double>;
using std::numbers::pi;

const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("frequency_response", read_frequency_response, frequency_response,
                {"material.shear_modulus=1.44", "waves.numbers=2 4 8", "adhesion.sizes=21 41 81",
                 "states.stick_ratios=0.6", "states.sizes=21 41 81", "states.alignments=6",
                 "step.ratios=1 0.3", "motion.sizes=21 41 81", "curve.shortest=1",
                 "curve.longest=100", "curve.points=3"});
  return all;
}

double order(const char* kernel, double stick_ratio, const char* scheme, double c) {
  return table_named(tables(), "orders")
      .latest(
          {{"kernel", kernel}, {"stick_ratio", stick_ratio}, {"scheme", scheme}, {"step_ratio", c}},
          "order");
}

double error(const char* kernel, double stick_ratio, const char* scheme, double c) {
  return table_named(tables(), "errors")
      .latest({{"kernel", kernel},
               {"stick_ratio", stick_ratio},
               {"scheme", scheme},
               {"step_ratio", c},
               {"elements", 81.0}},
              "error");
}

TEST(FrequencyResponseStudy, WhereAllAdheresTheOrderIsTwoByRememberedElseOne) {
  for (const char* kernel : {"plane", "strip"}) {
    for (const double c : {1.0, 0.3}) {
      EXPECT_NEAR(order(kernel, 1, "remembered", c), 2, 0.1) << kernel << ' ' << c;
      EXPECT_LT(error(kernel, 1, "remembered", c), 1e-4) << kernel << ' ' << c;
      EXPECT_NEAR(order(kernel, 1, "direct", c), 1, 0.2) << kernel << ' ' << c;
      EXPECT_GT(error(kernel, 1, "direct", c), 20 * error(kernel, 1, "remembered", c));
    }
  }
}

// Over the places of the stick-slip point within an element.
TEST(FrequencyResponseStudy, AboutAStateWithSlipRememberedIsSecondOrderAndDirectFirst) {
  EXPECT_GT(order("plane", 0.6, "remembered", 1), 1.7);
  EXPECT_LT(error("plane", 0.6, "remembered", 1), 1e-4);
  EXPECT_NEAR(order("plane", 0.6, "direct", 1), 1, 0.35);
  EXPECT_GT(error("plane", 0.6, "direct", 1), 5e-4);
  EXPECT_LT(error("plane", 0.6, "direct", 1), 1e-2);
}

// Whole steps shift tractions from node to node: on the contact's grid all schemes are one then.
TEST(FrequencyResponseStudy, SchemesOnTheContactsGridAgreeInWholeSteps) {
  for (const double stick_ratio : {1.0, 0.6}) {
    for (const char* scheme : {"relaxed", "relaxed_traction", "fractional"}) {
      EXPECT_NEAR(error("plane", stick_ratio, scheme, 1) / error("plane", stick_ratio, "direct", 1),
                  1, 1e-6)
          << scheme;
    }
  }
}

TEST(FrequencyResponseStudy, TakesAllSchemesOfTheCatalogue) {
  for (const char* name : {"measured", "step_errors"}) {
    std::set<std::string> seen;
    const Table& table = table_named(tables(), name);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      seen.insert(std::get<std::string>(table.at(i, "scheme")));
    }
    for (const std::string_view scheme : advection_names()) {
      EXPECT_TRUE(seen.contains(std::string(scheme))) << name << ' ' << scheme;
    }
  }
}

TEST(FrequencyResponseStudy, CurvesAreTheClosedForm) {
  const Table& curves = table_named(tables(), "curves");
  const auto of = [&](const char* name, double length, const char* column) {
    for (std::size_t i = 0; i < curves.rows(); ++i) {
      if (std::get<std::string>(curves.at(i, "case")) != name) continue;
      if (std::abs(curves.number(i, "wavelength_ratio") - length) > 1e-9) continue;
      if (curves.number(i, "stick_ratio") == 1) return curves.number(i, column);
    }
    return std::nan("");
  };
  EXPECT_NEAR(of("plane", 1, "size"), .0517347791, 1e-10);
  EXPECT_NEAR(of("plane", 10, "size"), .5486576576, 1e-9);
  EXPECT_NEAR(of("plane", 100, "phase"), -.1557111453, 1e-9);
  EXPECT_NEAR(of("strip", 10, "phase"), -.853218234, 1e-9);
  EXPECT_NEAR(of("winkler", 10, "from_winkler"), 0, 1e-12);
  EXPECT_NEAR(of("winkler", 10, "size"), std::abs(winkler_response(pi / 5)), 1e-12);
}

// Springs add up the creepage: at the distance r from the leading edge the creepage has acted since
// the material entered: (1 - exp(-i kappa r))/(i kappa) times the rest.
TEST(FrequencyResponseStudy, SpringsAddUpTheirCreepage) {
  for (const double kappa : {1e-6, 0.9e-3, 1.1e-3, 0.05, 1.0, 7.0}) {
    const auto real = [&](double y) { return std::sin(kappa * y) / kappa; };
    const auto imaginary = [&](double y) {
      return -2 * std::pow(std::sin(kappa * y / 2), 2) / kappa;
    };
    using boost::math::quadrature::gauss;
    const Complex force(gauss<double, 30>::integrate(real, 0.0, 2.0),
                        gauss<double, 30>::integrate(imaginary, 0.0, 2.0));
    EXPECT_LT(std::abs(winkler_response(kappa) - force / 2.0), 1e-9) << kappa;
  }
}

TEST(FrequencyResponseStudy, Steps) {
  const Table& errors = table_named(tables(), "step_errors");
  const auto of = [&](const char* scheme, double elements, const char* column) {
    return errors.latest({{"scheme", scheme}, {"step_ratio", 1.0}, {"elements", elements}}, column);
  };
  for (const char* column : {"force_error", "creepage_error"}) {
    const double ratio = of("remembered", 21, column) / of("remembered", 81, column);
    EXPECT_GT(ratio, 9) << column;
    EXPECT_LT(ratio, 40) << column;
  }
  EXPECT_NEAR(of("direct", 21, "force_error") / of("direct", 81, "force_error"), 81. / 21, 0.8);
  EXPECT_NEAR(of("remembered", 81, "peak") / of("remembered", 81, "exact_peak"), 1, 0.03);
  EXPECT_GT(of("direct", 81, "peak") / of("direct", 81, "exact_peak"), 1.05);
  EXPECT_GT(of("remembered", 81, "exact_peak") - of("remembered", 21, "exact_peak"),
            0.9 * std::log(81. / 21) / (2 * pi));
}

TEST(FrequencyResponseStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()), (std::vector<std::string>(5, "ours")));
}

}  // namespace microslip::experiments::frequency_response_test
