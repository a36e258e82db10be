// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/speed_accuracy.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "microslip/rolling/schemes.hpp"
#include "microslip/support/convergence.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::speed_accuracy_test {

constexpr double steady_limit = 2e7;

std::vector<Table> measured() {
  return tables_of(
      "speed_accuracy", read_speed_accuracy, speed_accuracy,
      {fmt::format("steady.operations={}", steady_limit), "grid.sizes=15 33 63 129 255",
       "timing.repeats=1e-9", "steady.step_ratios=1 0.1", "steady.unknowns=1 3 6 12",
       "transient.operations=1e7", "transient.step_ratios=1 0.5 2", "transient.reference=1023",
       "cylinder.operations=3e6", "cylinder.distance=0.5", "cylinder.step_ratios=1",
       "cylinder.reference=129", "rough.hursts=0.8 0.3", "rough.rows=2049",
       "rough.sizes=63 255 1023", "rough.reference=8191"});
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all = measured();
  return all;
}

const Table& runs() { return table_named(tables(), "runs"); }

std::string text(const Table& table, std::size_t row, const std::string& column) {
  return std::get<std::string>(table.at(row, column));
}

std::string written(const Table& table) {
  std::ostringstream out;
  table.write(out, "speed_accuracy", {});
  return out.str();
}

std::string contestant(const Table& table, std::size_t row) {
  std::string name;
  for (const char* column : {"problem", "scheme", "edge", "basis", "solver"}) {
    name += text(table, row, column) + ' ';
  }
  return name + std::to_string(table.number(row, "step_ratio"));
}

TEST(SpeedAccuracyStudy, WhatIsNotMeasuredTimeIsTheSameBytes) {
  const std::vector<Table> again = measured();
  for (const char* name : {"runs", "fronts", "cheapest", "claims"}) {
    EXPECT_EQ(written(table_named(tables(), name)), written(table_named(again, name))) << name;
  }
}

TEST(SpeedAccuracyStudy, FailuresAreListed) {
  std::map<std::string, std::set<double>> sizes;
  std::map<std::string, int> reasons;
  for (std::size_t i = 0; i < runs().rows(); ++i) {
    EXPECT_TRUE(sizes[contestant(runs(), i)].insert(runs().number(i, "elements")).second);
    const std::string status = text(runs(), i, "status");
    const bool ok = status == "ok";
    ++reasons[status.substr(0, status.find(':'))];
    EXPECT_EQ(std::isnan(runs().number(i, "work")), !ok) << status;
    EXPECT_EQ(std::isnan(runs().number(i, "rounds")), !ok) << status;
  }
  for (const auto& [name, of] : sizes) {
    const bool chebyshev = name.find("chebyshev") != std::string::npos;
    const bool inversion = name.find("inversion") != std::string::npos;
    EXPECT_EQ(of.size(), inversion ? 1u : chebyshev ? 4u : 5u) << name;
  }
  EXPECT_EQ(reasons.size(), 4u);
  EXPECT_GT(reasons["ok"], 300);
  EXPECT_GT(reasons["not run"], 50);
  EXPECT_GT(reasons["does not exist"], 50);
  EXPECT_EQ(reasons["not converged"], 2);  // Chebyshev collocation with one unknown
}

bool has_run(const char* problem, const char* column, std::string_view value) {
  for (std::size_t i = 0; i < runs().rows(); ++i) {
    if (text(runs(), i, "problem") == problem && text(runs(), i, column) == value) return true;
  }
  return false;
}

TEST(SpeedAccuracyStudy, AllOfTheCataloguesTakePart) {
  for (const SteadyEntry& entry : steady_schemes()) {
    const char* column = entry.by_elements ? "edge" : "scheme";
    for (const char* problem : {"plane", "strip"}) {
      EXPECT_TRUE(has_run(problem, column, entry.name)) << entry.name;
    }
  }
  for (const AdvectionEntry& entry : advection_schemes()) {
    for (const char* problem : {"transient", "creepage"}) {
      EXPECT_TRUE(has_run(problem, "scheme", entry.name)) << entry.name;
    }
  }
  for (const std::string_view basis : basis_names()) {
    for (const char* problem : {"plane", "strip", "transient", "creepage"}) {
      EXPECT_TRUE(has_run(problem, "basis", basis)) << basis;
    }
  }
}

TEST(SpeedAccuracyStudy, LimitsHold) {
  for (std::size_t i = 0; i < runs().rows(); ++i) {
    const std::string problem = text(runs(), i, "problem");
    if (problem != "plane" && problem != "strip") continue;
    if (text(runs(), i, "status") != "ok") continue;
    EXPECT_LT(runs().number(i, "work"), 8 * steady_limit) << contestant(runs(), i);
  }
}

/// Whether a run takes part in what a row of another table is about.
bool takes_part(std::size_t run, const Table& table, std::size_t row) {
  if (text(runs(), run, "status") != "ok") return false;
  if (text(runs(), run, "problem") != text(table, row, "problem")) return false;
  const std::string scheme = text(runs(), run, "scheme");
  const std::string among = text(table, row, "among");
  if (among == "all") return true;
  if (among == "elements") return scheme != "chebyshev" && scheme != "inversion";
  return among == (scheme == "collocation" ? text(runs(), run, "edge") : scheme);
}

TEST(SpeedAccuracyStudy, NothingBeatsTheFronts) {
  const Table& fronts = table_named(tables(), "fronts");
  ASSERT_GT(fronts.rows(), 50u);
  for (std::size_t row = 0; row < fronts.rows(); ++row) {
    const std::string quantity = text(fronts, row, "quantity");
    // Below rounding, errors are equal.
    const double error = std::max(fronts.number(row, "error"), 1e-13);
    for (std::size_t run = 0; run < runs().rows(); ++run) {
      if (!takes_part(run, fronts, row)) continue;
      const double other = std::max(runs().number(run, quantity + "_error"), 1e-13);
      EXPECT_FALSE(other < error * (1 - 1e-6) &&
                   runs().number(run, "work") <= fronts.number(row, "work"))
          << quantity << ": " << contestant(runs(), run) << " beats " << contestant(fronts, row);
    }
    const bool goes_on = row > 0 && text(fronts, row - 1, "quantity") == quantity &&
                         text(fronts, row - 1, "problem") == text(fronts, row, "problem") &&
                         text(fronts, row - 1, "among") == text(fronts, row, "among");
    if (!goes_on) continue;
    EXPECT_LT(fronts.number(row, "error"), fronts.number(row - 1, "error"));
    EXPECT_GT(fronts.number(row, "work"), fronts.number(row - 1, "work"));
  }
}

// A figure draws a line for each.
TEST(SpeedAccuracyStudy, EverySchemeHasItsFront) {
  const Table& fronts = table_named(tables(), "fronts");
  std::set<std::string> have;
  for (std::size_t row = 0; row < fronts.rows(); ++row) {
    have.insert(text(fronts, row, "problem") + ' ' + text(fronts, row, "quantity") + ' ' +
                text(fronts, row, "among"));
  }
  for (const SteadyEntry& entry : steady_schemes()) {
    for (const char* problem : {"plane force ", "strip traction "}) {
      EXPECT_TRUE(have.contains(problem + std::string(entry.name))) << problem << entry.name;
    }
  }
  for (const AdvectionEntry& entry : advection_schemes()) {
    for (const char* problem : {"creepage force ", "transient traction ", "transient noise "}) {
      EXPECT_TRUE(have.contains(problem + std::string(entry.name))) << problem << entry.name;
    }
  }
  EXPECT_TRUE(have.contains("plane force aligned"));
  EXPECT_TRUE(have.contains("cylinder energy remembered verlet"));
}

TEST(SpeedAccuracyStudy, TheThesisIsBesideTheCheapest) {
  const Table& cheapest = table_named(tables(), "cheapest");
  std::map<std::string, int> reached;
  for (std::size_t row = 0; row < cheapest.rows(); ++row) {
    const bool steady =
        text(cheapest, row, "problem") == "plane" || text(cheapest, row, "problem") == "strip";
    double least = HUGE_VAL;
    for (std::size_t run = 0; run < runs().rows(); ++run) {
      const bool thesis = steady ? text(runs(), run, "edge") == "standard"
                                 : text(runs(), run, "scheme").starts_with("direct");
      const double error = runs().number(run, text(cheapest, row, "quantity") + "_error");
      if (text(runs(), run, "problem") != text(cheapest, row, "problem") || !thesis) continue;
      if (!(error <= cheapest.number(row, "accuracy"))) continue;
      least = std::min(least, runs().number(run, "work"));
    }
    if (least == HUGE_VAL) {
      EXPECT_EQ(text(cheapest, row, "thesis_scheme"), "none");
      EXPECT_TRUE(std::isnan(cheapest.number(row, "gain")));
      continue;
    }
    ++reached[text(cheapest, row, "thesis_scheme")];
    EXPECT_EQ(cheapest.number(row, "thesis_work"), least);
    EXPECT_EQ(cheapest.number(row, "gain"), least / cheapest.number(row, "work"));
    EXPECT_GE(cheapest.number(row, "gain"), 1);
  }
  EXPECT_GT(reached["standard"], 3);
  EXPECT_GT(reached["direct"], 1);
}

TEST(SpeedAccuracyStudy, CheapestIsTheLeastWorkOfAllRuns) {
  const Table& cheapest = table_named(tables(), "cheapest");
  int none = 0;
  for (std::size_t row = 0; row < cheapest.rows(); ++row) {
    double least = HUGE_VAL;
    for (std::size_t run = 0; run < runs().rows(); ++run) {
      const double error = runs().number(run, text(cheapest, row, "quantity") + "_error");
      if (!takes_part(run, cheapest, row) || !(error <= cheapest.number(row, "accuracy"))) continue;
      least = std::min(least, runs().number(run, "work"));
    }
    if (text(cheapest, row, "scheme") == "none") {
      EXPECT_EQ(least, HUGE_VAL);
      ++none;
    } else {
      EXPECT_EQ(cheapest.number(row, "work"), least);
      EXPECT_LE(cheapest.number(row, "error"), cheapest.number(row, "accuracy"));
    }
  }
  EXPECT_GT(none, 0);
}

/// Fitted over the sizes of a contestant that has no others with the same cells.
double order_of(const char* problem, const char* scheme, const char* edge, double step_ratio,
                const char* error) {
  std::vector<double> sizes, errors;
  for (std::size_t i = 0; i < runs().rows(); ++i) {
    const double c = runs().number(i, "step_ratio");
    if (text(runs(), i, "problem") != problem || text(runs(), i, "scheme") != scheme ||
        text(runs(), i, "edge") != edge || text(runs(), i, "basis") != "constant" ||
        text(runs(), i, "solver") != "dense" || text(runs(), i, "status") != "ok" ||
        !(c == step_ratio || (std::isnan(c) && std::isnan(step_ratio)))) {
      continue;
    }
    sizes.push_back(runs().number(i, "elements"));
    errors.push_back(runs().number(i, error));
  }
  EXPECT_GE(sizes.size(), 3u) << scheme << ' ' << edge;
  return fitted_order(sizes, errors);
}

TEST(SpeedAccuracyStudy, Orders) {
  EXPECT_NEAR(order_of("plane", "collocation", "standard", 1, "force_error"), 1, 0.2);
  EXPECT_NEAR(order_of("plane", "collocation", "known_edge", 1, "force_error"), 1.6, 0.25);
  EXPECT_NEAR(order_of("plane", "collocation", "aligned", 1, "force_error"), 1.9, 0.35);
  // The grids are coarse, and the errors have noise.
  EXPECT_GT(order_of("plane", "collocation", "calibrated", NAN, "force_error"), 1.7);
  EXPECT_GT(order_of("strip", "collocation", "calibrated", NAN, "force_error"), 1.7);
  // The limit of work leaves three coarse grids; finer ones are in order/transient_order_test.cpp.
  EXPECT_GT(order_of("transient", "remembered", "calibrated", 1, "creep_error"), 1.7);
  EXPECT_NEAR(order_of("transient", "direct", "standard", 1, "creep_error"), 1.1, 0.25);
  EXPECT_GT(order_of("creepage", "remembered", "calibrated", 1, "force_error"), 1.7);
  EXPECT_NEAR(order_of("creepage", "direct", "standard", 1, "force_error"), 1.1, 0.3);
  EXPECT_GT(order_of("transient", "remembered", "calibrated", 1, "noise_error"), 1.7);
}

TEST(SpeedAccuracyStudy, SolversDifferInWorkOnly) {
  std::map<std::string, std::size_t> dense;
  int pairs = 0;
  for (std::size_t i = 0; i < runs().rows(); ++i) {
    if (text(runs(), i, "status") != "ok" || text(runs(), i, "problem") == "cylinder") continue;
    std::string name = contestant(runs(), i) + std::to_string(runs().number(i, "elements"));
    if (text(runs(), i, "solver") == "dense") dense[name] = i;
    const std::size_t at = name.find(" fft ");
    if (at == std::string::npos) continue;
    const auto other = dense.find(name.replace(at, 5, " dense "));
    if (other == dense.end()) continue;
    ++pairs;
    for (const char* error : {"force_error", "creep_error", "traction_error"}) {
      const double by_fft = runs().number(i, error);
      if (std::isnan(by_fft)) continue;
      EXPECT_NEAR(by_fft, runs().number(other->second, error), 1e-8) << name << ' ' << error;
    }
  }
  EXPECT_GT(pairs, 50);
}

TEST(SpeedAccuracyStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()), (std::vector<std::string>{"reproduced", "reproduced"}));
}

}  // namespace microslip::experiments::speed_accuracy_test
