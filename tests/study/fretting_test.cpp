// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fretting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "microslip/experiments/superposed_shift.hpp"
#include "microslip/reference/fretting_cycle.hpp"
#include "microslip/rolling/transient.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::fretting_test {

const Material material{1.44, 0.28};  // 2 (1 - nu)/G = 1

/// The contact of these tests, another one than that of the study.
const std::vector<std::string> contact{
    "material.shear_modulus=1.44", "contact.half_width=2", "contact.peak_traction=3",
    "contact.bound_polynomial=1 -0.4 0.1 0.2", "kernel.length=20"};

const std::vector<Table>& tables() {
  static const std::vector<Table> all = [] {
    std::vector<std::string> changes{"grid.sizes=30 60",
                                     "cycle.force_ratios=0.3 0.8",
                                     "cycle.points=7",
                                     "cycle.error_force_ratios=0.5 0.9",
                                     "cycle.all_force_ratios=0.001 0.05 0.1 0.3 0.9",
                                     "cycle.lengths=2 1e4",
                                     "run.elements=40",
                                     "run.force_ratio=0.3",
                                     "run.swing=0.6",
                                     "run.elements_rolled=11.7",
                                     "run.step_ratio=0.7"};
    changes.insert(changes.end(), contact.begin(), contact.end());
    return tables_of("fretting", read_fretting, fretting, changes);
  }();
  return all;
}

// Errors depend on where the ends of the stick zones lie in their elements, so that it takes many
// amplitudes to tell an order.
TEST(FrettingStudy, OrdersErrorsAndVerdicts) {
  const std::vector<Table> found = tables_of("fretting", read_fretting, fretting, contact);
  const auto order = [&](const char* bound, const char* scheme, const char* column) {
    return table_named(found, "orders").latest({{"bound", bound}, {"scheme", scheme}}, column);
  };
  const auto error = [&](const char* bound, const char* scheme, const char* column) {
    return table_named(found, "errors").latest({{"bound", bound}, {"scheme", scheme}}, column);
  };
  for (const char* bound : {"hertz", "polynomial"}) {
    EXPECT_NEAR(order(bound, "direct", "shift"), 1.5, 0.2) << bound;
    EXPECT_NEAR(order(bound, "remembered", "shift"), 2, 0.3) << bound;
    EXPECT_NEAR(order(bound, "direct", "dissipation"), 1.5, 0.3) << bound;
    EXPECT_LT(error(bound, "remembered", "shift"), error(bound, "direct", "shift") / 4) << bound;
    EXPECT_LT(error(bound, "remembered", "dissipation"), 1e-3) << bound;
    EXPECT_LT(error(bound, "direct", "dissipation"), 2e-3) << bound;
  }
  EXPECT_NEAR(order("hertz", "remembered", "dissipation"), 1.1, 0.3);
  EXPECT_GT(order("polynomial", "remembered", "dissipation"), 1.2);  // the first N sees slip badly
  EXPECT_EQ(verdicts(found), std::vector<std::string>(12, "ours"));
}

TEST(FrettingStudy, VerdictsOnTheContactOfTheStudy) {
  EXPECT_EQ(verdicts(tables_of("fretting", read_fretting, fretting)),
            std::vector<std::string>(12, "ours"));
}

TEST(FrettingStudy, LoopsAreClosedAndExact) {
  const Table& loops = table_named(tables(), "loops");
  EXPECT_EQ(loops.rows(), 2U * 3 * 8);
  for (std::size_t i = 0; i < loops.rows(); ++i) {
    EXPECT_LT(std::abs(loops.number(i, "error")), 1e-3);
    const double exact = loops.number(i, "exact");
    EXPECT_NEAR(loops.number(i, "displacement"), exact, 2e-3 * (1 + std::abs(exact)));
  }
  for (const double amplitude : {0.3, 0.8}) {
    const auto end = [&](const char* way) {
      return loops.latest({{"amplitude", amplitude}, {"way", way}}, "displacement");
    };
    EXPECT_NEAR(end("forth"), end("out"), 1e-12);
    EXPECT_NEAR(end("back"), -end("out"), 1e-12);
  }
}

TEST(FrettingStudy, EnergiesBalanceToRounding) {
  const Table& run = table_named(tables(), "run");
  double dissipated = 0;
  for (std::size_t i = 0; i < run.rows(); ++i) {
    EXPECT_LT(std::abs(run.number(i, "imbalance")), 1e-13) << i;
    dissipated = run.number(i, "dissipated");
  }
  EXPECT_GT(dissipated, 0.1 * run.number(0, "work"));
  EXPECT_EQ(run.number(run.rows() - 1, "stage"), 5);
  const Table& cycles = table_named(tables(), "cycles");
  for (std::size_t i = 0; i < cycles.rows(); ++i) {
    EXPECT_LT(std::abs(cycles.number(i, "imbalance")), 1e-12) << i;
  }
}

TEST(FrettingStudy, LengthMovesTheShiftAlone) {
  const Table& lengths = table_named(tables(), "lengths");
  for (const char* scheme : {"direct", "remembered"}) {
    const auto value = [&](double length, const char* column) {
      return lengths.latest({{"scheme", scheme}, {"length", length}}, column);
    };
    const double k = 1 / std::numbers::pi;
    const double force =
        PolynomialBound(2, 3, (Eigen::VectorXd(4) << 1, -0.4, 0.1, 0.2).finished()).total() / 2;
    EXPECT_NEAR(value(1e4, "shift") - value(2, "shift"), k * force * std::log(1e4 / 2), 1e-9);
    EXPECT_LT(std::abs(value(1e4, "difference")), 1e-11);
  }
}

TEST(FrettingStudy, SlipThatNoElementSeesIsNone) {
  const Table& curve = table_named(tables(), "curve");
  const auto cubes = [&](const char* scheme, double n, double tau) {
    return curve.latest({{"scheme", scheme}, {"elements", n}, {"amplitude", tau}}, "cubes");
  };
  EXPECT_LT(std::abs(cubes("direct", 60, 0.001)), 1e-7);
  EXPECT_NEAR(cubes("remembered", 60, 0.3), 1 + 0.3 / 2 + 0.3 * 0.09, 0.04);
}

// Hertz's bound is a polynomial of degree 0.
TEST(SuperposedShift, IsMindlinsForHertzsBound) {
  const PolynomialBound bound(2, 3, Eigen::VectorXd::Ones(1));
  const SuperposedShift shift(bound, 1, 20);
  for (const double tau : {0.01, 0.3, 0.9}) {
    const double force = tau * bound.total();
    const FrettingCycle cycle(material, HertzBound(2, 3), force);
    EXPECT_NEAR(shift.stick_zone(force).half_length, std::sqrt(1 - tau), 1e-14);
    EXPECT_NEAR(shift.stick_zone(force).centre, 0, 1e-14);
    EXPECT_NEAR(shift.shift(force) / -cycle.shift(force, 20), 1, 1e-12);
    EXPECT_NEAR(shift.dissipation(force) / cycle.dissipation(), 1, tau < 0.1 ? 1e-8 : 1e-11);
  }
}

// The tractions that it subtracts are those of a smaller load with the same surfaces: their strain
// is the same. Here by elements, where the contact of before slips and sticks.
TEST(SuperposedShift, FindsTheStickZoneOfElements) {
  const PolynomialBound bound(2, 3, (Eigen::VectorXd(4) << 1, -0.4, 0.1, 0.2).finished());
  const double force = 0.6 * bound.total();
  TransientRolling rolling({.contact = {PlaneKernel(material, 20), bound},
                            .grid = Grid({.half_width = 2, .elements = 400}),
                            .basis = constant_basis(),
                            .scheme = Direct{}});
  rolling.shift(PrescribedForce{force});
  const auto zone = SuperposedShift(bound, 1, 20).stick_zone(force);
  Eigen::Index first = 0;
  while (rolling.state().zones[static_cast<std::size_t>(first)] != Zone::adhesion) ++first;
  const Eigen::Index last = first + rolling.state().adhesion_elements - 1;
  const double dx = 4.0 / 400;
  EXPECT_NEAR(rolling.x()[first] - dx / 2, 2 * (zone.centre - zone.half_length), 1.5 * dx);
  EXPECT_NEAR(rolling.x()[last] + dx / 2, 2 * (zone.centre + zone.half_length), 1.5 * dx);
  EXPECT_LT(zone.half_length, 0.95);
  EXPECT_GT(std::abs(zone.centre), 0.02);
}

}  // namespace microslip::experiments::fretting_test
