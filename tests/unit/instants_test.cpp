// SPDX-License-Identifier: GPL-3.0-or-later
// motion.instants and motion.instants_at: the ends of steps that are nearest to places of a run.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "good_scene.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::instants_test {

const std::string transient = "problem transient" + good_contact +
                              "start { type rest }\nload { creepage 0.4 }\n"
                              "motion { distance 3 }\nstep { ratio 0.5 }\n";

Scene scene_with(const std::vector<std::string>& settings) {
  Scene scene = scene_of(transient);
  for (const std::string& setting : settings) scene.set(setting);
  scene.read_files_by([](const std::string&) { return "q creepage\n0 0.1\n2 0.1\n1 0.2\n"; });
  return scene;
}

TransientScene read(const std::vector<std::string>& settings) {
  Scene scene = scene_with(settings);
  auto found = std::get<TransientScene>(read_model(scene));
  scene.reject_unread();
  return found;
}

std::string refusal(const std::vector<std::string>& settings) {
  return message_in_keys([&] { read(settings); });
}

std::size_t warnings_with(const std::vector<std::string>& settings) {
  Scene scene = scene_with(settings);
  read_model(scene);
  return static_cast<std::size_t>(std::ranges::count_if(
      scene.warnings(),
      [](const Warning& warning) { return warning.key.starts_with("motion.instants"); }));
}

/// The ends of steps by sums, and the nearest one to each place by trial of all.
std::vector<std::size_t> expected_of(const TransientScene& scene,
                                     const std::vector<double>& places) {
  const double dx =
      2 * scene.problem.grid.half_width() / static_cast<double>(scene.problem.grid.size());
  std::vector<double> ends{0};
  for (std::size_t k = 0; ends.back() < scene.distance * (1 - 1e-9); ++k) {
    const double step = dx * scene.step_ratios[k % scene.step_ratios.size()];
    ends.push_back(std::min(scene.distance, ends.back() + step));
  }
  std::set<std::size_t> nearest;
  for (const double place : places) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      if (std::abs(ends[k] - place) < std::abs(ends[best] - place)) best = k;
    }
    nearest.insert(best);
  }
  return {nearest.begin(), nearest.end()};
}

TEST(Instants, AreTheNearestEndsOfSteps) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (int trial = 0; trial < 40; ++trial) {
    std::string ratios, texts;
    for (int k = 0; k <= trial % 3; ++k) ratios += fmt::format(" {}", 0.2 + part(random));
    const double distance = 1 + 2 * part(random);
    std::vector<double> places;
    for (int k = 0; k < 1 + trial % 7; ++k) places.push_back(distance * part(random));
    std::ranges::sort(places);
    for (const double place : places) texts += fmt::format(" {}", place);
    const std::vector<std::string> run{"step.ratio=" + ratios,
                                       fmt::format("motion.distance={}", distance)};
    auto at = run, even = run;
    at.push_back("motion.instants_at=" + texts);
    const TransientScene given = read(at);
    EXPECT_EQ(given.instants, expected_of(given, places));
    const int count = 1 + trial % 9;
    even.push_back(fmt::format("motion.instants={}", count));
    std::vector<double> evenly;
    for (int k = 1; k <= count; ++k) evenly.push_back(distance * k / count);
    const TransientScene spread = read(even);
    EXPECT_EQ(spread.instants, expected_of(spread, evenly));
    EXPECT_EQ(warnings_with(even), spread.instants.size() < evenly.size() ? 1U : 0U);
  }
  EXPECT_TRUE(read({}).instants.empty());
}

// Steps end where the bodies turn, too; places are distances along the way.
TEST(Instants, OfRunsThatTurnAreAlongTheWay) {
  const std::vector<std::string> turning{"load.creepage=", "load.file=run", "motion.distance=",
                                         "step.ratio=", "motion.instants_at=0 2 3"};
  EXPECT_EQ(read(turning).instants, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Instants, AreRefusedInOneLine) {
  const std::string of_run = ": expected distances in rising order, from 0 to 3, of the run";
  EXPECT_EQ(refusal({"motion.instants_at=1 3.1"}), "motion.instants_at = 3.1" + of_run);
  EXPECT_EQ(refusal({"motion.instants_at=-1 2"}), "motion.instants_at = -1" + of_run);
  EXPECT_EQ(refusal({"motion.instants_at=2 1"}), "motion.instants_at = 1" + of_run);
  EXPECT_EQ(refusal({"motion.instants_at=1 1"}), "motion.instants_at = 1" + of_run);
  EXPECT_TRUE(refusal({"motion.instants_at=1 two"}).starts_with("motion.instants_at = '1 two': "));
  EXPECT_TRUE(refusal({"motion.instants_at=1 N"}).starts_with("motion.instants_at = '1 N': "));
  EXPECT_EQ(refusal({"motion.instants_at=0:0.002:3"}),
            "motion.instants_at = '0:0.002:3': expected at most 1000 distances, not 1501");
  for (const std::string count : {"0", "-1", "1001"}) {
    EXPECT_EQ(
        refusal({"motion.instants=" + count}),
        "motion.instants = " + count + ": expected a whole number 1 ... 1 000; none without it");
  }
  EXPECT_EQ(refusal({"motion.instants=2.5"}), "motion.instants = '2.5': expected a whole number");
  EXPECT_TRUE(refusal({"motion.instants=2", "motion.instants_at=1"})
                  .starts_with("expected only one of 'motion.instants' and 'motion.instants_at'"));
}

TEST(Instants, TakeMemory) {
  const Model without = read({"grid.elements=1001"});
  const Model with = read({"grid.elements=1001", "motion.instants=100"});
  EXPECT_GT(memory_needed(with), memory_needed(without) + 100 * 1001 * 300.0);
  EXPECT_EQ(work_needed(with), work_needed(without));
}

}  // namespace microslip::instants_test
