// SPDX-License-Identifier: GPL-3.0-or-later
// --save and start.state: a run in two parts is one run, and what does not fit is refused.
#include <fstream>
#include <string>
#include <vector>

#include "robustness/bad_scenes.hpp"

namespace microslip::saved_states_test {

class SavedStates : public BadScenes {
 protected:
  static std::string scene() {
    return "problem transient\n" + good_contact +
           "step { ratio \"0.7 1 0.35\" }\nmotion { distance 4 }\nload { creepage 0.4 }\n" +
           "start { type cattaneo\n  force -0.5 }\n";
  }

  std::string state() const { return (folder_ / "run.state").string(); }
  std::string save() const { return " --save '" + state() + "'"; }
  std::string go_on() const {
    return " --set start.force= --set start.type=state --set start.state='" + state() + "'";
  }

  /// The rows of a table, without its comments and names.
  std::vector<std::string> rows(const std::string& table) const {
    std::vector<std::string> lines;
    std::ifstream in(out() / table);
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with("#")) lines.push_back(line);
    }
    lines.erase(lines.begin());
    return lines;
  }

  /// One run, and the same in two parts, the first of which ends at a distance.
  void expect_same_in_parts(const std::string& text, double distance) const {
    SCOPED_TRACE(distance);
    const Outcome whole = run(text, "");
    ASSERT_EQ(whole.status, 0) << whole.error;
    const auto traction = rows("traction.tsv"), history = rows("history.tsv");
    const Outcome first = run(text, "--set motion.distance=" + std::to_string(distance) + save());
    ASSERT_EQ(first.status, 0) << first.error;
    auto parts = rows("history.tsv");
    const Outcome second = run(text, go_on());
    ASSERT_EQ(second.status, 0) << second.error;
    EXPECT_EQ(rows("traction.tsv"), traction);
    const auto rest = rows("history.tsv");
    ASSERT_GT(rest.size(), 1U);
    EXPECT_EQ(rest.front(), parts.back());
    parts.insert(parts.end(), rest.begin() + 1, rest.end());
    EXPECT_EQ(parts, history);
  }
};

// Ends of steps, as a user writes them; 0.1 of them is dx.
TEST_F(SavedStates, PutTwoPartsTogetherAsOneRun) {
  for (const double distance : {0.07, 0.17, 0.205, 1.23, 2.05, 3.895}) {
    expect_same_in_parts(scene(), distance);
  }
  std::ofstream(folder_ / "run.tsv")
      << "q force half_width\n0 -0.5 1\n1 -0.8 1.2\n2 0.3 0.9\n3 -0.6 1\n4 -0.2 1.1\n";
  const std::string run = "problem transient\n" + good_contact +
                          "start { type cattaneo\n  force -0.5 }\nload { file \"" +
                          (folder_ / "run.tsv").string() + "\" }\n";
  expect_same_in_parts(run, 1);
  expect_same_in_parts(run, 3);
  expect_same_in_parts(run + "step { ratio 0.5 }\n", 1.45);
}

TEST_F(SavedStates, AreWhatTheRunWithoutThemIs) {
  ASSERT_EQ(run(scene(), "").status, 0);
  const auto history = rows("history.tsv");
  ASSERT_EQ(run(scene(), save()).status, 0);
  EXPECT_EQ(rows("history.tsv"), history);
  EXPECT_EQ(text_of(state()).rfind("microslip state 4\n", 0), 0U);
}

TEST_F(SavedStates, OfOtherProblemsAreRefused) {
  const auto expect_nothing_saved = [&](const std::string& text, const std::string& options,
                                        const std::string& named) {
    expect_rejected(text, options, named);
    EXPECT_FALSE(fs::exists(state()));
  };
  expect_nothing_saved(good_scene, save(),
                       "scene.info:1: problem = 'steady': expected transient with --save");
  expect_nothing_saved(scene(), "--set step.scheme=direct" + save(),
                       "step.scheme = 'direct': expected remembered with --save");
  expect_nothing_saved(scene(), "--save ''", "--save '': expected the name of a file");
  expect_nothing_saved(scene(), "--save '" + folder_.string() + "'", "expected the name of a file");
  expect_nothing_saved(scene(), "--save '" + (folder_ / "none" / "state").string() + "'",
                       "expected a folder that is there");
  expect_nothing_saved(scene(), "--save '" + (out() / "traction.tsv").string() + "'",
                       "expected a name that differs from the tables");
}

TEST_F(SavedStates, ThatDoNotFitAreRefused) {
  ASSERT_EQ(run(scene(), "--set motion.distance=2.05" + save()).status, 0);
  fs::remove_all(out());
  const std::string text = text_of(state());
  const std::string named = "start.state = '" + state() + "': ";
  expect_rejected(scene(), go_on() + " --set kernel.width=41",
                  named + "kernel.width = 41: expected 40, as where the state was saved");
  expect_rejected(scene(), go_on() + " --set grid.elements=21", named + "grid.elements = 21: ");
  expect_rejected(scene(), go_on() + " --set contact.peak_traction=2",
                  named + "bound of element 1 = ");
  expect_rejected(scene(), go_on() + " --set motion.distance=2",
                  "motion.distance = 2: expected more than the distance of start.state, 2.05");
  expect_rejected(scene(),
                  "--set start.type=state --set start.force=", "missing key 'start.state'");
  expect_rejected(scene(), "--set start.state=x", "key 'start.state' has no role here");
  const auto expect_damaged = [&](const std::string& other) {
    std::ofstream(state()) << other;
    expect_rejected(scene(), go_on(), named + "expected ");
  };
  expect_damaged("");
  expect_damaged("x\ttraction\n0\t1\n");
  expect_damaged(text.substr(0, text.size() / 2));
  std::string changed = text;
  changed[changed.size() / 2] = changed[changed.size() / 2] == '1' ? '2' : '1';
  expect_damaged(changed);
  fs::remove(state());
  expect_rejected(scene(), go_on(), named + "cannot read it");
}

// A run that fails leaves the state of an earlier one.
TEST_F(SavedStates, StayWhereARunFails) {
  std::ofstream(state()) << "earlier";
  std::ofstream(folder_ / "out") << "no folder";
  EXPECT_EQ(run(scene(), save()).status, 1);
  EXPECT_EQ(text_of(state()), "earlier");
  fs::remove(folder_ / "out");
  EXPECT_EQ(run(scene(), "--set solver.tolerance=1e-12 --set solver.condition=1" + save()).status,
            2);
  EXPECT_EQ(text_of(state()), "earlier");
}

}  // namespace microslip::saved_states_test
