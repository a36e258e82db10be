// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that stand, turn and roll back, as they are typed.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"
#include "robustness/bad_scenes.hpp"

namespace microslip::turning_runs_test {

const std::string line =
    "material { youngs_modulus 200 GPa\n poisson_ratio 0.28 }\ncontact { half_width 5\n "
    "peak_traction 300 }\nkernel { type plane\n length 20 }\ngrid { elements 60 }\n";
const std::string ellipse =
    "material { youngs_modulus 200 GPa\n poisson_ratio 0.28 }\ncontact { half_width 6\n "
    "lateral_half_width 4\n peak_traction 300 }\ngrid { rows 6\n elements 8 }\n";

/// Columns of a history.
using History = std::map<std::string, std::vector<double>>;

class TurningRuns : public BadScenes {
 protected:
  std::string scene(const std::string& contact, const std::string& rows,
                    const std::string& keys = "start { type rest }\n") const {
    std::ofstream(folder_ / "run.tsv") << rows;
    return "problem transient\n" + contact + keys + "load { file \"" +
           (folder_ / "run.tsv").string() + "\"\n radius 460 mm }\n";
  }

  std::string scene_by_force(const std::string& contact, const std::string& rows) const {
    std::string text = scene(contact, rows);
    const std::string radius = "\n radius 460 mm";
    return text.erase(text.find(radius), radius.size());
  }

  History history_of(const std::string& text, const std::string& options = "") const {
    const Outcome outcome = run(text, options);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    if (outcome.status != 0) return {};
    const WrittenTable read = read_table("history", text_of(out() / "history.tsv"));
    History history;
    for (const Column& column : read.table.columns()) {
      for (std::size_t i = 0; i < read.table.rows(); ++i) {
        history[column.name].push_back(
            std::stod(std::get<std::string>(read.table.at(i, column.name))));
      }
    }
    return history;
  }
};

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double sign,
                 double error) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], sign * expected[i], error) << "row " << i;
  }
}

/// Times, velocities and rotations that brake, stand and roll back.
std::string braking(double sign, const std::string& more = "") {
  std::ostringstream rows;
  rows.precision(17);
  rows << "t v omega" << (more.empty() ? "" : " lateral_creepage spin") << '\n';
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i;
    const double v = t < 1.5 ? 6 * (1.5 - t) : t < 2.5 ? 0 : -5 * (t - 2.5);
    const double slip = 0.012 * std::sin(2 * t);
    rows << t << ' ' << sign * v << ' ' << sign * (v - slip) / 460 << more << '\n';
  }
  return rows.str();
}

TEST_F(TurningRuns, HaveMirrorImages) {
  const History forth = history_of(scene(line, braking(1))),
                back = history_of(scene(line, braking(-1)));
  for (const std::string name : {"q", "force", "shift"}) {
    expect_near(back.at(name), forth.at(name), -1, 1e-6);
  }
  for (const std::string name : {"creepage", "dissipation", "loss", "t", "adhesion_elements"}) {
    expect_near(back.at(name), forth.at(name), 1, 1e-6);
  }
  const History in_space = history_of(scene(ellipse, braking(1, " 0.0004 0.00005"))),
                mirrored = history_of(scene(ellipse, braking(-1, " -0.0004 0.00005")));
  for (const std::string name : {"q", "force", "spin_moment", "shift", "rotation"}) {
    expect_near(mirrored.at(name), in_space.at(name), -1, 1e-3);
  }
  for (const std::string name : {"lateral_force", "lateral_shift", "loss"}) {
    expect_near(mirrored.at(name), in_space.at(name), 1, 1e-3);
  }
}

// Positions, times and shifts are those of the file.
TEST_F(TurningRuns, HaveTheWayOfTheFile) {
  for (const std::string& contact : {line, ellipse}) {
    const History history = history_of(scene(contact, braking(1)));
    const auto& t = history.at("t");
    double sum = 0, expected = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      sum += history.at("shift")[i];
      if (i > 0) {  // linear between rows
        expected += 0.012 * (std::sin(2 * t[i]) + std::sin(2 * t[i - 1])) / 2 * (t[i] - t[i - 1]);
      }
      const double fell = std::max(0.0, t[i] - 2.5);
      const double q = t[i] < 1.5 ? 6 * (1.5 - t[i] / 2) * t[i] : 6.75 - 2.5 * fell * fell;
      EXPECT_NEAR(history.at("q")[i], q, 1e-9) << t[i];
      EXPECT_NEAR(sum, expected, 1e-8) << t[i];
    }
    EXPECT_NEAR(t.back(), 4, 1e-9);
    EXPECT_NEAR(summary_value("distance"), 6.75 + 2.5 * 2.25, 1e-9);
    EXPECT_NEAR(summary_value("position"), 6.75 - 2.5 * 2.25, 1e-9);
    EXPECT_NEAR(summary_value("cumulative_creep"), sum, 1e-12);
  }
}

// A wheel that nearly stands is one that stands.
TEST_F(TurningRuns, StandAsTheyCreepAlong) {
  const auto rows = [](double v) {
    std::ostringstream text;
    text << "t v omega\n0 4 0.00868\n1 " << v << ' ' << v / 460 << "\n2 " << v << ' '
         << v / 460 - 8e-6 << "\n3 " << v << ' ' << v / 460 + 3e-6 << "\n4 4 0.00868\n";
    return text.str();
  };
  for (const std::string& contact : {line, ellipse}) {
    const double full = contact == line ? 2356 : 15080;
    const std::string steps = "start { type rest }\nstep { ratio 0.25 }\n";
    const History standing = history_of(scene(contact, rows(0), steps)),
                  creeping = history_of(scene(contact, rows(1e-4)));
    const auto force_at = [&](const History& history, double time) {
      const auto& t = history.at("t");
      for (std::size_t i = 0; i < t.size(); ++i) {
        if (std::abs(t[i] - time) < 1e-9) return history.at("force")[i];
      }
      return std::nan("");
    };
    for (const double time : {2.0, 3.0}) {
      EXPECT_NEAR(force_at(standing, time), force_at(creeping, time), 0.01 * full) << time;
    }
  }
}

// A jump of a force is a fast change of it.
TEST_F(TurningRuns, JumpAsTheyChangeFast) {
  const auto rows = [](const std::string& unit, double size, double gap) {
    std::ostringstream text;
    text << "q force [" << unit << "]\n0 0\n3 " << 0.4 * size << '\n'
         << 3 + gap << ' ' << -0.5 * size << "\n8 " << -0.5 * size << '\n';
    return text.str();
  };
  for (const std::string& contact : {line, ellipse}) {
    const std::string unit = contact == line ? "N/mm" : "N";
    const double size = contact == line ? 2356 : 15080;
    const std::string steps = "--set step.ratio=0.05";
    const History jump = history_of(scene_by_force(contact, rows(unit, size, 0)), steps);
    const double crept = summary_value("cumulative_creep");
    EXPECT_NEAR(jump.at("force").back(), -0.5 * size, 1e-6 * size);
    history_of(scene_by_force(contact, rows(unit, size, 1e-3)), steps);
    EXPECT_NEAR(summary_value("cumulative_creep") / crept, 1, 0.02);
  }
}

TEST_F(TurningRuns, ThatCannotBeAreRefusedInOneLine) {
  const std::string turns = "q creepage\n0 0.001\n5 0.001\n2 0.001\n";
  const auto refused = [&](const std::string& rows, const std::string& options,
                           const std::string& named) {
    expect_rejected(scene_by_force(line, rows), options, named);
  };
  refused(turns, "--set step.scheme=direct --set step.ratio=1",
          "step.scheme = 'direct': expected remembered, which alone turns");
  refused(turns, "--set step.tolerance=1e-3", "step.tolerance = '1e-3': expected none where the");
  refused(turns, "--save state",
          "expected rows that neither turn nor shift the bodies with --save");
  refused("q creepage\n0 0\n0 0.1\n", "", "distance of the rows = 0: expected a number > 0");
  refused("q force\n0 0\n1 0\n1 9000\n2 0\n", "",
          "row 3: force = 9000: expected an absolute value");
  expect_rejected(scene_by_force(ellipse, "q force half_width\n0 0 6\n1 0 6\n1 0 7\n2 0 7\n"), "",
                  "row 3: half_width = 7: expected 6 of the row before, as nothing is rolled");
}

}  // namespace microslip::turning_runs_test
