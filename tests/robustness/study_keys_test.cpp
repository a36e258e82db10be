// SPDX-License-Identifier: GPL-3.0-or-later
// Every study reads every key of its scene strictly.
#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/support/format.hpp"
#include "robustness/executables.hpp"

namespace microslip::study_keys_test {

/// A row that --print-keys=markdown has for a key of the study's own.
struct Row {
  std::string study, key, unit, accepted;
};

class Studies : public Executables {
 protected:
  static std::vector<std::string> studies() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(MICROSLIP_SOURCE) / "studies")) {
      if (entry.is_directory()) names.push_back(entry.path().filename());
    }
    return names;
  }

  std::string program(const std::string& study) const {
    return std::string(MICROSLIP_BIN) + "/" + study;
  }

  Outcome set(const std::string& study, const std::string& assignment) const {
    return run_command(program(study) + " --quick --set '" + assignment + "' --out '" +
                       out().string() + "'");
  }

  std::vector<Row> own_keys() const {
    std::vector<Row> rows;
    for (const std::string& study : studies()) {
      std::istringstream text(run_command(program(study) + " --print-keys=markdown").output);
      for (std::string line; std::getline(text, line);) {
        std::smatch cells;
        const std::regex row(R"(\| `(.*)` \| .* \| (.*?) ?\| (.*) \|)");
        if (std::regex_match(line, cells, row))
          rows.push_back({study, cells[1], cells[2], cells[3]});
      }
    }
    return rows;
  }
};

TEST_F(Studies, RejectATextThatIsNoValueOfAnyKey) {
  int keys = 0;
  for (const std::string& study : studies()) {
    std::istringstream text(run_command(program(study) + " --print-scene").output);
    for (const std::string& key : Scene::parse(text, study).keys()) {
      SCOPED_TRACE(study + " " + key);
      const Outcome outcome = set(study, key + "=,");
      EXPECT_EQ(outcome.status, 1);
      EXPECT_TRUE(outcome.error.starts_with(study + ": " + key + " = ','")) << outcome.error;
      EXPECT_EQ(outcome.error.find('\n') + 1, outcome.error.size());
      EXPECT_FALSE(fs::exists(out()));
      ++keys;
    }
  }
  EXPECT_GT(keys, 150);
}

// The same name is the same thing, in the same unit, as in scenes; parts put their name before it.
TEST_F(Studies, SpeakTheVocabularyOfScenes) {
  const std::regex a_ratio("(.*[._])?ratios?"), a_force("(.*[._])?forces?");
  const std::regex known_ratio(R"((step\.|.*[._](step|stick|force|poisson)_)ratios?)");
  const std::vector<Row> rows = own_keys();
  EXPECT_GT(rows.size(), 100U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.study + " " + row.key);
    const Key* of_scenes = find_key(row.key);
    if (of_scenes != nullptr && !row.unit.empty()) {
      EXPECT_EQ(row.unit, of_scenes->unit);
    }
    if (std::regex_match(row.key, a_ratio)) {
      EXPECT_TRUE(std::regex_match(row.key, known_ratio));
    }
    EXPECT_FALSE(std::regex_match(row.key, a_force));
  }
}

// Numbers on the wrong side of both ends.
TEST_F(Studies, RefuseWhatIsOutOfTheRangeThatTheyPrint) {
  std::size_t ends = 0;
  const auto expect_refused = [&](const Row& row, double value) {
    SCOPED_TRACE(row.study + " " + row.key + " " + row.accepted + " " + format_short(value));
    const Outcome outcome = set(row.study, row.key + "=" + format_short(value));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.error.starts_with(row.study + ": " + row.key + " = " + format_short(value) +
                                          ": expected "))
        << outcome.error;
    ++ends;
  };
  for (Row row : own_keys()) {
    row.accepted = std::regex_replace(row.accepted, std::regex("10⁶"), "1e6");
    row.accepted = std::regex_replace(row.accepted, std::regex(R"((\d) (?=\d{3}\b))"), "$1");
    std::smatch parts;
    const std::regex least(R"(^(> |≥ |above |at least |)(-?\d[\d.e-]*) ?.*)");
    const std::regex most(R"(^[^\[]*?( \.\.\. |at most |below )(\d[\d.e-]*).*)");
    if (std::regex_match(row.accepted, parts, least)) {
      const bool open = parts[1] == "> " || parts[1] == "above ";
      expect_refused(row, std::stod(parts[2]) - (open ? 0 : 1));
    }
    if (std::regex_match(row.accepted, parts, most)) {
      expect_refused(row, std::stod(parts[2]) +
                              (parts[1] == "below " ? 0 : 1) * std::max(1.0, std::stod(parts[2])));
    }
  }
  EXPECT_GT(ends, 180U);
}

// Studies demand what they print about lists, and about a number beside another.
TEST_F(Studies, DemandWhatTheyPrint) {
  const auto expect_refused = [&](const std::string& study, const std::string& assignment,
                                  const std::string& note) {
    const Outcome outcome = set(study, assignment);
    EXPECT_EQ(outcome.status, 1) << study << ' ' << assignment;
    EXPECT_TRUE(outcome.error.starts_with(study + ": " +
                                          assignment.substr(0, assignment.find('=')) + " = "))
        << outcome.error;
    EXPECT_TRUE(outcome.error.ends_with("; " + note + "\n")) << outcome.error;
  };
  const std::string rising = "two or more, in rising order",
                    twice = "two or more, each twice the one before";
  for (const char* sizes : {"15", "15 16"}) {
    expect_refused("basis_convergence", std::string("grid.sizes=") + sizes,
                   "two or more, odd, so that a node lies at the centre");
    expect_refused("leading_edge", std::string("grid.sizes=") + sizes, twice);
    expect_refused("open_problems", std::string("grid.sizes=") + sizes, twice);
  }
  for (const char* sizes : {"25", "50 25"}) {
    expect_refused("fretting", std::string("grid.sizes=") + sizes, rising);
    expect_refused("world_fixed", std::string("noise.sizes=") + sizes, rising);
    for (const char* key : {"adhesion", "states", "motion"}) {
      expect_refused("frequency_response", key + std::string(".sizes=") + sizes, rising);
    }
  }
  expect_refused("leading_edge", "profile.stick_ratio=0.55", "one of load.stick_ratios");
  expect_refused("smoothing", "pulse.elements=200", "odd");
  for (const char* key : {"step.ratios", "comparison.step_ratio", "wiggles.relaxed_step_ratios",
                          "wiggles.direct_step_ratios"}) {
    expect_refused("under_relaxation", std::string(key) + "=1.1", "at most step.relaxation");
  }
  expect_refused("under_relaxation", "motion.elements_rolled=25 24", "in rising order");
  expect_refused("energy_balance", "snapshots.positions=1 0.5", "in rising order");
  expect_refused("energy_balance", "error.sizes=25 50", "three or more");
  expect_refused("energy_balance", "motion.sizes=25 50", "three or more");
  expect_refused("energy_balance", "control.step_ratios=1 2", "in falling order");
  expect_refused("world_fixed", "noise.step_ratios=1 0.5", "1 and noise.step_ratio among them");
  expect_refused("world_fixed", "noise.largest_cut=30", "at least the second of noise.sizes");
  expect_refused("world_fixed", "noise.distance=0.1", "four elements or more, on every grid");
  expect_refused("world_fixed", "creepage.elements_rolled=1000", "less than are rolled");
  for (const char* key : {"grid.elements=200", "shapes.elements=200", "cost.sizes=51 100"}) {
    expect_refused("fractional_power", key, "odd");
  }
  expect_refused("fractional_power", "shapes.steps=33 1", "in rising order");
  expect_refused("fractional_power", "cost.largest_schur=51", "at least the third of cost.sizes");
  for (const char* ratios : {"0.5", "0.5 0.4", "0.1 0.2 0.3"}) {
    expect_refused("open_problems", std::string("cases.stick_ratios=") + ratios,
                   "two, in rising order");
  }
  for (const char* key :
       {"cycle.force_ratios", "cycle.error_force_ratios", "cycle.all_force_ratios"}) {
    expect_refused("fretting", std::string(key) + "=0.5 0.4", "in rising order");
  }
  expect_refused("fretting", "run.force_ratio=0", "not 0");
  expect_refused("fretting", "run.swing=0.6",
                 "less than 1 together with the size of run.force_ratio");
  for (const char* sizes : {"25", "33 15"}) {
    expect_refused("speed_accuracy", std::string("grid.sizes=") + sizes,
                   "odd multiples of three, in rising order");
  }
  expect_refused("frequency_response", "step.ratios=0.3 1", "the first is 1");
  expect_refused("frequency_response", "curve.longest=0.2", "more than curve.shortest");
  expect_refused("extremes", "grid.elements=50", "odd");
  expect_refused("extremes", "endurance.states=1000 100", "in rising order");
}

// Keys of their own have units, too; and a distance in elements takes none.
TEST_F(Studies, TakeUnits) {
  EXPECT_EQ(set("energy_balance", "error.distance=2 cm").error.find("error.distance"),
            std::string::npos);
  const Outcome furlongs = set("energy_balance", "error.distance=2 furlong");
  EXPECT_EQ(furlongs.status, 1);
  EXPECT_NE(furlongs.error.find("expected a number in mm or another of its kind"),
            std::string::npos)
      << furlongs.error;
  const Outcome elements = set("fretting", "run.elements_rolled=5 mm");
  EXPECT_EQ(elements.status, 1);
  EXPECT_NE(elements.error.find("expected a number in no unit"), std::string::npos)
      << elements.error;
}

}  // namespace microslip::study_keys_test
