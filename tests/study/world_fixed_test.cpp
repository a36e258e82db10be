// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/world_fixed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "microslip/experiments/creepage_noise.hpp"
#include "microslip/experiments/cut_elements.hpp"
#include "microslip/halfspace/influence.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::world_fixed_test {

using Eigen::VectorXd;

constexpr Material material{1, 0.28};

CattaneoToCarter rolling_on(Eigen::Index n) {
  return {.kernel = PlaneKernel(material, 200),
          .bound = HertzBound(1, 1),
          .grid = Grid({.half_width = 1, .elements = n}),
          .basis = constant_basis(),
          .force = 0.64 * HertzBound(1, 1).total()};
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all =
      tables_of("world_fixed", read_world_fixed, world_fixed,
                {"noise.sizes=25 50 100 200", "noise.step_ratios=1 0.5 0.2 0.1 0.01",
                 "error.step_ratios=1 0.2 0.1", "error.refinement=8"});
  return all;
}

/// The row whose first column is the name and whose second one is the number or word.
double value(const std::string& table, const std::string& name, const Cell& second,
             const std::string& column) {
  const Table& rows = table_named(tables(), table);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (rows.at(i, "treatment") == Cell(name) && rows.at(i, rows.columns()[1].name) == second) {
      return rows.number(i, column);
    }
  }
  ADD_FAILURE() << "no row " << name << " in " << table;
  return 0;
}

double noise(const std::string& treatment, const std::string& series, double at,
             const std::string& column = "deviation") {
  const Table& rows = table_named(tables(), "noise");
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (rows.at(i, "treatment") == Cell(treatment) && rows.at(i, "series") == Cell(series) &&
        rows.number(i, series) == at) {
      return rows.number(i, column);
    }
  }
  ADD_FAILURE() << "no row " << treatment << " in noise";
  return 0;
}

double order(const std::string& treatment) {
  return value("orders", treatment, 200.0, "deviation_order");
}

/// Displacement at a place by what lies on elements of other widths  [mm]
double displacement(const VectorXd& x, const VectorXd& width, const VectorXd& traction, double at) {
  double sum = 0;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    sum += traction[j] * influence(PlaneKernel(material, 200), constant_shape(), width[j],
                                   (at - x[j]) / width[j]);
  }
  return sum;
}

// In adhesion the material in the middle of an element moves along with the body: S = 0.
TEST(CutElements, MeetTheContactConditions) {
  const CattaneoToCarter rolling = rolling_on(20);
  const double elements = 20.4, dx = 2 / elements;
  for (const auto treatment : {EdgeElements::at_node, EdgeElements::cell_mean, EdgeElements::cut}) {
    CutElementRolling contact(rolling, treatment, elements);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> ratio(0.01, 1.5);
    for (int k = 0; k < 40; ++k) {
      const double c = ratio(random);
      const VectorXd x = contact.x(), width = contact.width(), traction = contact.traction();
      contact.step(c);
      EXPECT_NEAR(contact.force(), rolling.force, 1e-11);
      if (treatment == EdgeElements::cut) {
        EXPECT_NEAR(contact.width().sum(), 2, 1e-12);
      }
      const VectorXd now = contact.x(), widths = contact.width();
      for (Eigen::Index i = 0; i < now.size(); ++i) {
        const double mean = (rolling.bound.integral(now[i] + widths[i] / 2) -
                             rolling.bound.integral(now[i] - widths[i] / 2)) /
                            widths[i];
        const double bound = treatment == EdgeElements::at_node ? rolling.bound(now[i]) : mean;
        const double p = contact.traction()[i];
        const double slip = c * dx * contact.creepage() +
                            displacement(now, widths, contact.traction(), now[i]) -
                            displacement(x, width, traction, now[i] + c * dx);
        if (contact.zones()[static_cast<std::size_t>(i)] == Zone::adhesion) {
          EXPECT_LE(std::abs(p), bound + 1e-9);
          EXPECT_NEAR(slip, 0, 1e-10);
        } else {
          EXPECT_NEAR(std::abs(p), bound, 1e-9);
          EXPECT_LE(slip * p, 1e-10);
        }
      }
    }
  }
}

// Steps that get there in larger steps have the noise of those that do not.
TEST(CutElements, LongerStepsBeforeDoNotMatter) {
  const CattaneoToCarter rolling = rolling_on(50);
  for (const std::string treatment : {"cell_mean", "cut"}) {
    const double step_ratio = 0.02;
    CutElementRolling contact(rolling,
                              treatment == "cut" ? EdgeElements::cut : EdgeElements::cell_mean, 50);
    for (int k = 0; k < 550; ++k) contact.step(step_ratio);
    double sum = 0, squares = 0;
    for (int k = 0; k < 50; ++k) {
      contact.step(step_ratio);
      sum += contact.creepage() / 50;
      squares += contact.creepage() * contact.creepage() / 50;
    }
    const Noise noise = creepage_noise(rolling, treatment, 12, step_ratio);
    EXPECT_NEAR(noise.mean, sum, 1e-4 * std::abs(sum));
    EXPECT_NEAR(noise.deviation, std::sqrt(squares - sum * sum) / std::abs(sum), 2e-4);
  }
}

// An independent program's figures.
TEST(WorldFixedStudy, NodesOnAndOffMakeNoiseOfOrderOneHalf) {
  EXPECT_NEAR(noise("at_node", "elements", 25), 0.46, 0.01);
  EXPECT_NEAR(noise("at_node", "elements", 200), 0.175, 0.001);
  EXPECT_GT(order("at_node"), 0.4);
  EXPECT_LT(order("at_node"), 0.6);
}

// The compliance of the adhesion area and the zeta function of the trailing nodes: no fit.
TEST(WorldFixedStudy, TheNoiseOfNodesOnAndOffIsPredicted) {
  for (const double n : {50.0, 100.0, 200.0}) {
    const double predicted = noise("at_node", "elements", n, "predicted");
    EXPECT_NEAR(noise("at_node", "elements", n, "noise"), predicted, 0.03 * predicted) << n;
  }
  for (const double c : {0.5, 0.2, 0.1, 0.01}) {
    const double predicted = noise("at_node", "step_ratio", c, "predicted");
    EXPECT_NEAR(noise("at_node", "step_ratio", c, "noise"), predicted, 0.03 * predicted) << c;
  }
}

TEST(WorldFixedStudy, AveragedAndCutElementsStayBelowOnePercent) {
  for (const std::string treatment : {"cell_mean", "cut"}) {
    EXPECT_NEAR(noise(treatment, "elements", 200), 0.005, 0.0004);
    EXPECT_GT(order(treatment), 0.9);
    EXPECT_LT(order(treatment), 1.2);
    EXPECT_LT(value("orders", treatment, 200.0, "largest"), 0.01);
    EXPECT_LT(noise(treatment, "elements", 200, "largest"), 0.0075);
    EXPECT_LT(noise(treatment, "step_ratio", 0.01), 1.25 * noise(treatment, "step_ratio", 0.1));
  }
  EXPECT_LT(noise("direct", "elements", 200), 0.002);
}

// The remaining jumps come from the border between adhesion and slip, not from the edges. The
// direct scheme has them, too, but less often.
TEST(WorldFixedStudy, WhereTheCreepageJumps) {
  EXPECT_GT(value("events", "at_node", "left", "share"), 0.95);
  for (const std::string treatment : {"cell_mean", "cut", "direct"}) {
    EXPECT_GT(value("events", treatment, "released", "share"), 0.9) << treatment;
  }
  EXPECT_LT(value("events", "cut", "entered", "largest_change"),
            0.5 * value("events", "cell_mean", "entered", "largest_change"));
}

TEST(WorldFixedStudy, ErrorsOfTheTractionDoNotDependOnTheStep) {
  EXPECT_NEAR(value("errors", "at_node", 0.1, "error"), 1.9e-3, 3e-4);
  for (const double c : {1.0, 0.2, 0.1}) {
    EXPECT_NEAR(value("errors", "cell_mean", c, "error"), 1.54e-3, 1e-4);
  }
  EXPECT_LT(value("errors", "cut", 0.1, "error"), 1.1e-3);
  EXPECT_NEAR(value("errors", "direct", 1.0, "error"), 1.9e-3, 2e-4);
  EXPECT_NEAR(value("errors", "direct", 0.1, "error"), 3.2e-2, 1e-3);
}

TEST(WorldFixedStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()),
            (std::vector<std::string>{"reproduced", "reproduced", "corrected", "corrected"}));
}

}  // namespace microslip::experiments::world_fixed_test
