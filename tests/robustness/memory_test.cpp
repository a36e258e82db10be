// SPDX-License-Identifier: GPL-3.0-or-later
// A task that needs more memory than there is, is refused before it begins, in one line that says
// how much; and the task needs what that line says.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "microslip/scene/cost.hpp"
#include "robustness/executables.hpp"
#include "scene_text.hpp"

namespace microslip::memory_test {

class Memory : public Executables {
 protected:
  /// \param kilobytes  of addresses
  Outcome run_within(int kilobytes, const std::string& program, const std::string& options) const {
    return run_command("ulimit -v " + std::to_string(kilobytes) + "; " MICROSLIP_BIN "/" + program +
                       " --out '" + out().string() + "' " + options);
  }

  void expect_refused(const Outcome& outcome, const std::string& says) const {
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.error.substr(0, says.size()), says);
    const std::string end = " GB are available\n";
    EXPECT_TRUE(outcome.error.ends_with(end)) << outcome.error;
    EXPECT_EQ(outcome.error.find('\n'), outcome.error.size() - 1);
    EXPECT_FALSE(fs::exists(out()));
  }

  /// Largest resident set of a solution  [bytes]
  double peak(const std::string& scene) const {
    std::ofstream(scene_file()) << scene;
    const pid_t child = fork();
    if (child == 0) {
      const std::string program = std::string(MICROSLIP_BIN) + "/microslip";
      execl(program.c_str(), "microslip", "--scene", scene_file().c_str(), "--out", out().c_str(),
            nullptr);
      _exit(99);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << scene;
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
  }

  static std::string with_elements(std::string scene, const std::string& elements) {
    return scene.replace(scene.find("elements 20"), 11, "elements " + elements);
  }
};

TEST_F(Memory, TooManyElementsAreRefused) {
  const std::string huge = " --set grid.elements=4000000";
  const std::string scene = "--scene '" + scene_file().string() + "'";
  std::ofstream(scene_file()) << good_scene;
  expect_refused(run_within(400000, "microslip", scene + huge),
                 "microslip: grid.elements = 4000000: would take about 4 GB, and 0.");
  expect_refused(run_within(400000, "microslip", scene + huge + " --set leading_edge=standard"),
                 "microslip: grid.elements = 4000000: would take about 4 GB, and 0.");
  expect_refused(
      run_within(400000, "microslip", scene + " --set grid.elements=15e3 --set solver.type=dense"),
      "microslip: grid.elements = 15000: would take about 7.2 GB, and 0.");
  expect_refused(
      run_within(400000, "microslip sweep", scene + " --set 'sweep.grid.elements=20 4e6'"),
      "microslip: case 2 of 2 (grid.elements = 4e6): grid.elements = 4000000: would take about 4 ");
  std::ofstream(scene_file()) << good_transient;
  expect_refused(run_within(400000, "microslip", scene + huge + " --set motion.distance=1e-4"),
                 "microslip: grid.elements = 4000000: would take about 9.6 GB, and 0.");
  EXPECT_EQ(run_within(400000, "microslip", scene).error, "");
}

TEST_F(Memory, WhatIsNotForeseenIsOneLine) {
  for (const char* program : {"carter", "microslip sweep"}) {
    std::ofstream(scene_file()) << good_scene;
    const Outcome outcome = run_within(
        150000, program,
        std::string(program) == "carter"
            ? "--set grid.elements=1000000"
            : "--scene '" + scene_file().string() + "' --set sweep.load.creepage=1:1:100000");
    EXPECT_EQ(outcome.status, 1);
    // In a sweep, the memory that is left may be too little to read the next case.
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_TRUE(outcome.error.ends_with(": not enough memory\n") ||
                outcome.error.ends_with(" GB are available\n"))
        << outcome.error;
    EXPECT_FALSE(fs::exists(out()));
  }
}

TEST_F(Memory, IsTakenAsForeseen) {
  constexpr double program = 12e6;
  const auto expect_near = [&](const std::string& text, const auto& read) {
    Scene scene = scene_of(text);
    const double foreseen = memory_needed(read(scene));
    const double taken = peak(text) - program;
    EXPECT_LT(taken, 1.1 * foreseen) << text;
    EXPECT_GT(taken, 0.5 * foreseen) << text;
  };
  const auto steady = [](Scene& scene) { return read_steady(scene); };
  expect_near(with_elements(good_scene, "30000") + "leading_edge standard", steady);
  expect_near(with_elements(good_scene, "30000") + "method chebyshev", steady);
  expect_near(with_elements(good_scene, "1500") + "leading_edge calibrated\nsolver { type dense }",
              steady);
  std::string transient = good_transient;
  transient.replace(transient.find("0.33"), 4, "1e-4");
  expect_near(with_elements(transient, "20000"),
              [](Scene& scene) { return read_transient(scene); });
}

}  // namespace microslip::memory_test
