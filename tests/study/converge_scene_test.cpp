// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the answers of `microslip converge` with orders and references that are known.
#include "microslip/experiments/converge_scene.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "good_scene.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::experiments::converge_scene_test {

const std::string steady = good_contact + "problem steady\nload { force -0.5 }\n";
const std::string transient = good_contact +
                              "problem transient\nload { force -0.6 }\nstart { type cattaneo }\n"
                              "step { ratio 0.3 }\nmotion { distance 1 }\n";

std::vector<Table> tables_of(const std::string& text, const std::string& settings = "") {
  Scene scene = scene_of(text + settings);
  return converge_tables(read_converge(scene), [](std::size_t, std::size_t) {});
}

double error_of(const Table& table, const std::string& scheme, double elements) {
  return table.latest({{"scheme", scheme}, {"elements", elements}}, "answer_error");
}

/// The mean order from N = 31 to 127.
double order_of(const Table& table, const std::string& scheme) {
  return std::log2(error_of(table, scheme, 31) / error_of(table, scheme, 127)) /
         std::log2(127.0 / 31);
}

TEST(Converge, KnowsTheOrdersOfSteadySchemes) {
  const std::vector<Table> tables = tables_of(steady);
  const Table& table = tables.front();
  EXPECT_NEAR(order_of(table, "standard"), 1, 0.15);
  EXPECT_NEAR(order_of(table, "trimmed"), 1, 0.15);
  EXPECT_GT(order_of(table, "known_edge"), 1.3);
  EXPECT_GT(order_of(table, "calibrated"), 1.6);
  EXPECT_LT(error_of(table, "inversion", 255), 1e-10);
  EXPECT_LT(error_of(table, "chebyshev", 255), 1e-10);
  EXPECT_LT(error_of(table, "calibrated", 127), error_of(table, "standard", 127) / 30);
  EXPECT_EQ(std::get<std::string>(tables[2].at(0, "value")), "inversion");
}

// Where the reference of the largest default N takes minutes, fewer are tried, and the scene says
// so.
TEST(Converge, TriesFewerElementsOfLongRuns) {
  using Elements = std::vector<Eigen::Index>;
  Scene scene = scene_of(transient);
  EXPECT_EQ(read_converge(scene).elements, (Elements{15, 31, 63, 127, 255}));
  EXPECT_TRUE(scene.warnings().empty());
  scene = scene_of(transient);
  scene.set("motion.distance=500");
  EXPECT_EQ(read_converge(scene).elements, (Elements{15, 31, 63, 127}));
  ASSERT_EQ(scene.warnings().size(), 1U);
  EXPECT_EQ(
      scene.warnings().front().line.find("converge.elements = 127: the largest N unless more"), 0U);
  scene = scene_of(transient + "converge { elements \"31 127\" }\n");
  scene.set("motion.distance=500");
  EXPECT_EQ(read_converge(scene).elements, (Elements{31, 127}));
  EXPECT_TRUE(scene.warnings().empty());
}

TEST(Converge, KnowsTheOrdersOfTransientSchemes) {
  const std::vector<Table> tables = tables_of(transient, "converge { elements \"31 63 127\" }\n");
  const Table& table = tables.front();
  EXPECT_NEAR(order_of(table, "remembered"), 2, 0.3);
  EXPECT_NEAR(order_of(table, "direct"), 1, 0.2);
  EXPECT_LT(error_of(table, "remembered", 127), error_of(table, "direct", 127) / 50);
  EXPECT_EQ(std::get<std::string>(tables[2].at(0, "value")), "remembered");
}

// Errors of an ellipse are those of its forces by a method that shares no grid with the reference.
TEST(Converge, MeasuresTheErrorsOfAnEllipse) {
  const std::string ellipse =
      "problem steady\nmaterial { shear_modulus 82000\n poisson_ratio 0.28 }\n"
      "contact { half_width 6\n lateral_half_width 4\n peak_traction 300 }\n"
      "load { creepage 0.002\n lateral_creepage 0.001\n spin 0.0002 }\n";
  const std::vector<Table> tables = tables_of(ellipse, "converge { elements \"5 8 14\" }\n");
  const Table& table = tables.front();
  Scene scene = scene_of(ellipse + "grid { rows 23\n elements 31 }\n");
  const auto fine = std::get<SteadyPatch>(read_model(scene));
  const SteadyPatchSolution exact = solve_steady(fine);
  for (const auto& [rows, elements] : {std::pair(4, 5), std::pair(6, 8), std::pair(10, 14)}) {
    Scene coarse = scene_of(ellipse);
    coarse.set("grid.elements=" + std::to_string(elements));
    coarse.set("grid.rows=" + std::to_string(rows));
    const auto patch = std::get<SteadyPatch>(read_model(coarse));
    const double expected = change_of(fine, solve_steady(patch), exact);
    const double reference = std::get<double>(tables[2].at(2, "value"));
    EXPECT_NEAR(error_of(table, "rows", elements), expected, 2 * reference + 1e-4);
  }
  EXPECT_LT(error_of(table, "rows", 14), 3e-3);
  EXPECT_LT(error_of(table, "rows", 14), error_of(table, "rows", 5) / 3);
}

/// An ellipse that begins to roll under a force along and a creepage across.
const std::string ellipse_steps =
    "problem transient\nmaterial { shear_modulus 82000\n poisson_ratio 0.28 }\n"
    "contact { half_width 6\n lateral_half_width 4\n peak_traction 300 }\n"
    "load { force -3000\n lateral_creepage 0.001\n spin 0.0001 }\nstart { type cattaneo }\n";

// All grids have the steps of the scene, whose own grid has 10 elements a row. The errors are those
// of runs that are made by hand, on a grid that is no multiple of the reference.
TEST(Converge, MeasuresTheErrorsOfStepsOfAnEllipse) {
  const std::string text = ellipse_steps +
                           "step { ratio \"1 0.5\" }\nmotion { distance 9 }\n"
                           "grid { rows 7\n elements 10 }\n";
  const std::vector<Table> tables = tables_of(text, "converge { elements \"5 8 16\" }\n");
  const Table& table = tables.front();
  const auto run = [&](int rows, int elements) {
    Scene scene = scene_of(text);
    scene.set("grid.rows=" + std::to_string(rows));
    scene.set("grid.elements=" + std::to_string(elements));
    scene.set("step.ratio=" + std::to_string(0.1 * elements) + " " +
              std::to_string(0.05 * elements));
    const auto read = std::get<PatchTransient>(read_model(scene));
    PatchRolling rolling(read.patch);
    rolling.shift(read.shifts.front());
    std::vector<Eigen::Vector3d> all;
    Eigen::Vector3d way = rolling.motion();
    double lost = rolling.dissipation();
    for_steps(9, {1.2, 0.6}, 0, [&](double from, double to, double length) {
      rolling.roll(length, read.loads.between(from, to));
      way += length * rolling.motion();
      lost += length * rolling.dissipation();
      all.push_back(rolling.resultants().cwiseQuotient(
          largest_resultants(read.patch.bound, rolling.contact())));
    });
    return std::tuple(all, way, lost);
  };
  const auto [exact, exact_way, exact_lost] = run(19, 25);
  const double reference = tables[2].number(2, "value");
  EXPECT_LT(reference, 5e-3);
  for (const auto& [rows, elements] : {std::pair(4, 5), std::pair(6, 8), std::pair(12, 16)}) {
    const auto [found, way, lost] = run(rows, elements);
    ASSERT_EQ(found.size(), 10U);
    double largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      largest = std::max(largest, (found[i] - exact[i]).lpNorm<Eigen::Infinity>());
    }
    const double of_way = (way - exact_way).head<2>().lpNorm<Eigen::Infinity>() /
                          exact_way.head<2>().lpNorm<Eigen::Infinity>();
    const double said = error_of(table, "remembered", elements);
    EXPECT_GE(said, std::max(largest, of_way) - 2 * reference - 1e-3) << elements;
    EXPECT_LE(said, 2 * std::max(largest, of_way) + 2 * reference + 1e-3) << elements;
    EXPECT_NEAR(table.latest({{"scheme", "remembered"}, {"elements", elements}}, "energy_error"),
                std::abs(lost / exact_lost - 1), 2 * reference + 2e-3);
    EXPECT_EQ(table.latest({{"scheme", "remembered"}, {"elements", elements}}, "steps"), 10);
  }
  EXPECT_LT(error_of(table, "remembered", 16), error_of(table, "remembered", 5) / 4);
  EXPECT_GT(error_of(table, "direct", 16), error_of(table, "remembered", 16));
}

// The reference's error is that of half its elements: about four times its own.
TEST(Converge, SaysHowFarTheReferenceMayBeOff) {
  const auto tables = [](const std::string& elements) {
    return tables_of(transient, "converge { elements " + elements + " }\n");
  };
  const std::vector<Table> coarse = tables("15"), fine = tables("63");
  const double said = coarse[2].number(2, "value");
  EXPECT_EQ(coarse[2].number(1, "value"), 63);
  const double found = error_of(fine.front(), "remembered", 63);
  EXPECT_LT(found, said);
  EXPECT_GT(found, said / 10);
}

TEST(Converge, RunsMeasureTimeAndAdvise) {
  const std::vector<Table> tables =
      tables_of(transient, "converge { elements \"31 63\"\n error 2e-3\n step_time 1 }\n");
  const Table& timing = tables[1];
  EXPECT_EQ(timing.rows(), tables.front().rows());
  for (std::size_t i = 0; i < timing.rows(); ++i) {
    EXPECT_GT(timing.number(i, "step_time"), 0);
    EXPECT_GE(timing.number(i, "time"), timing.number(i, "step_time"));
  }
  const Table& advice = tables[3];
  ASSERT_EQ(advice.rows(), 2U);
  EXPECT_TRUE(std::get<std::string>(advice.at(0, "advice"))
                  .starts_with("for an error of 0.002 in the creepage: remembered with "));
  EXPECT_TRUE(std::get<std::string>(advice.at(1, "advice"))
                  .starts_with("within 1 s a step: remembered with grid.elements 63 (error "));
}

TEST(Converge, RefusesWhatItCannotCompare) {
  const auto refusal = [](const std::string& text, const std::string& setting = "") {
    return message([&] {
      Scene scene = scene_of(text);
      if (!setting.empty()) scene.set(setting);
      converge_tables(read_converge(scene), [](std::size_t, std::size_t) {});
    });
  };
  EXPECT_EQ(refusal(steady, "converge.error=0"),
            "converge.error = 0: expected a number above 0, at most 1");
  EXPECT_EQ(
      refusal(steady, "converge.elements=1 2"),
      "converge.elements = 1: expected whole numbers 2 ... 100 000; in rising order, 15 31 63 "
      "127 255 without it; of an ellipse up to 66");
  EXPECT_EQ(refusal(steady, "converge.elements=20 20"),
            "converge.elements = 20: expected whole numbers 2 ... 100 000; in rising order, 15 31 "
            "63 127 255 without it; of an ellipse up to 66");
  EXPECT_EQ(refusal(steady, "converge.step_time=1 ms"),
            "problem = 'steady': expected transient with converge.step_time");
  EXPECT_EQ(refusal(steady, "load.force=0"), "converge: expected a load that is not zero");
  const std::string rolled = ellipse_steps + "step { ratio 1 }\nmotion { distance 2 }\n";
  EXPECT_EQ(refusal(rolled, "converge.reference=chebyshev"),
            "converge.reference = 'chebyshev': expected best or fine for an ellipse");
  EXPECT_EQ(refusal(rolled, "converge.elements=10 67"),
            "converge.elements = 67: expected at most 66 in an ellipse");
  EXPECT_TRUE(
      refusal(transient, "converge.elements=50000")
          .starts_with("converge.elements = 50000: expected fewer: the reference with 200003 "
                       "takes "));
}

}  // namespace microslip::experiments::converge_scene_test
