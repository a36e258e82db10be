// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps by the built executable: the same files whatever threads, shards and interrupts; what is
// done is not done again; bad input is one line and changes nothing.
#include <sys/types.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <map>
#include <thread>
#include <vector>

#include "robustness/executables.hpp"

namespace microslip::sweeps_test {

using Files = std::map<std::string, std::string>;

const std::string good_sweep = good_scene + R"(
sweep {
  leading_edge "calibrated standard"
  grid { elements "15:5:25" }
  load { creepage "0.1:log3:1" }
}
)";
constexpr int cases = 18;

class Sweeps : public Executables {
 protected:
  Outcome sweep(const std::string& options = "", const std::string& scene = good_sweep) const {
    return run_program("microslip", "sweep", scene, options);
  }

  Outcome merge() const {
    return run_command(std::string(MICROSLIP_BIN) + "/microslip merge --out '" + out().string() +
                       "'");
  }

  fs::path case_file(const std::string& number) const {
    return out() / "cases" / (number + ".tsv");
  }

  /// All files by name, except for their origin; none if there is no folder.
  Files files() const {
    Files all;
    if (!fs::exists(out())) return all;
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
      const std::string name = fs::relative(entry.path(), out());
      if (!entry.is_regular_file() || name.starts_with("provenance")) continue;
      all[name] = text_of(entry.path());
    }
    return all;
  }

  /// Cells of a column of a table.
  static std::vector<std::string> column(const fs::path& file, const std::string& name) {
    std::ifstream in(file);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with('#')) continue;
      rows.emplace_back();
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
    }
    const auto at = std::find(rows.at(0).begin(), rows.at(0).end(), name) - rows.at(0).begin();
    std::vector<std::string> all;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      all.push_back(rows[i].at(static_cast<std::size_t>(at)));
    }
    return all;
  }

  void expect_rejected(const std::string& options, const std::string& named,
                       const std::string& scene = good_sweep) const {
    const Files before = files();
    const Outcome outcome = sweep(options, scene);
    EXPECT_EQ(outcome.status, 1) << options;
    EXPECT_EQ(outcome.error.rfind("microslip: ", 0), 0U) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(named), std::string::npos) << outcome.error;
    EXPECT_EQ(files(), before) << options;
  }

  /// Starts a sweep, sends a signal when its first case is done, and returns the exit status.
  int interrupted(const std::string& scene, int signal) const {
    std::ofstream(scene_file()) << scene;
    const pid_t child = fork();
    if (child == 0) {
      std::freopen((folder_ / "stderr").c_str(), "w", stderr);
      const std::string program = std::string(MICROSLIP_BIN) + "/microslip";
      execl(program.c_str(), "microslip", "sweep", "--quiet", "--threads", "2", "--scene",
            scene_file().c_str(), "--out", out().c_str(), nullptr);
      _exit(99);
    }
    using namespace std::chrono_literals;
    for (int i = 0; i < 10000 && !has_a_case(); ++i) std::this_thread::sleep_for(1ms);
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// The line at the end of a sweep.
  std::string done(const std::string& begin) const {
    return begin + "; tables in " + out().string() + '\n';
  }

  bool has_a_case() const {
    if (!fs::exists(out() / "cases")) return false;
    for (const auto& entry : fs::directory_iterator(out() / "cases")) {
      if (entry.path().extension() == ".tsv") return true;
    }
    return false;
  }
};

TEST_F(Sweeps, ACaseIsWhatItsSceneGivesAlone) {
  const Outcome outcome = sweep("--threads 2 --tables");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.output, done("microslip: 18 cases, 0 of them finished before"));
  const fs::path table = out() / "sweep.tsv";
  EXPECT_EQ(column(table, "grid.elements").size(), static_cast<std::size_t>(cases));
  EXPECT_EQ(column(table, "status"), std::vector<std::string>(cases, "ok"));
  EXPECT_EQ(column(table, "leading_edge")[16], "standard");
  EXPECT_EQ(column(table, "grid.elements")[16], "25");
  EXPECT_EQ(column(table, "load.creepage")[16], "0.316227766016838");
  const std::string force = column(table, "force")[16];
  const auto tractions = column(out() / "cases" / "17" / "traction.tsv", "traction");
  EXPECT_TRUE(fs::exists(out() / "provenance.txt"));

  fs::remove_all(out());
  EXPECT_EQ(run_program("microslip", "", good_scene,
                        "--set leading_edge=standard --set load.creepage=0.316227766016838 "
                        "--set grid.elements=25")
                .status,
            0);
  EXPECT_EQ(column(out() / "summary.tsv", "value")[0], force);
  EXPECT_EQ(column(out() / "traction.tsv", "traction"), tractions);
}

TEST_F(Sweeps, SameBytesForAnyThreadsShardsAndInterrupts) {
  ASSERT_EQ(sweep("--threads 1 --tables").status, 0);
  const Files once = files();
  EXPECT_EQ(once.size(), 3U * cases + 2);

  fs::remove_all(out());
  EXPECT_EQ(sweep("--threads 4 --tables").status, 0);
  EXPECT_EQ(files(), once);

  fs::remove_all(out());
  for (const char* shard : {"3/4", "1/4", "4/4", "2/4"}) {
    EXPECT_EQ(sweep(std::string("--tables --shard ") + shard).status, 0);
    EXPECT_FALSE(fs::exists(out() / "sweep.tsv"));
  }
  EXPECT_EQ(merge().status, 0);
  EXPECT_EQ(files(), once);

  fs::remove(out() / "sweep.tsv");
  fs::remove(case_file("02"));
  fs::remove_all(out() / "cases" / "03");
  const std::string row = text_of(case_file("18"));
  std::ofstream(case_file("18")) << row.substr(0, row.size() - 5);
  std::ofstream(case_file("17")) << "";
  EXPECT_EQ(sweep("--tables").output, done("microslip: 18 cases, 14 of them finished before"));
  EXPECT_EQ(files(), once);
}

TEST_F(Sweeps, WhatIsDoneIsNotDoneAgain) {
  ASSERT_EQ(sweep("--shard 1/3").output, done("microslip: 6 cases, 0 of them finished before"));
  const auto written = fs::last_write_time(case_file("01"));
  EXPECT_EQ(sweep("--shard 1/2").output, done("microslip: 9 cases, 3 of them finished before"));
  EXPECT_EQ(sweep().output, done("microslip: 18 cases, 12 of them finished before"));
  EXPECT_EQ(sweep().output, done("microslip: 18 cases, 18 of them finished before"));
  EXPECT_EQ(fs::last_write_time(case_file("01")), written);
  EXPECT_EQ(sweep("--shard 99/99").output, done("microslip: 0 cases, 0 of them finished before"));
}

TEST_F(Sweeps, SignalsLeaveWholeCasesAndTheSweepGoesOn) {
  const std::string scene =
      good_scene + "leading_edge standard\nsweep { grid { elements \"150:1:249\" } }";
  for (const auto& [signal, status] : {std::pair(SIGTERM, 143), std::pair(SIGINT, 130)}) {
    fs::remove_all(out());
    EXPECT_EQ(interrupted(scene, signal), status);
    EXPECT_FALSE(fs::exists(out() / "sweep.tsv"));
    for (const auto& [name, text] : files()) EXPECT_FALSE(name.ends_with(".part")) << name;
  }
  const Outcome outcome = sweep("", scene);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(outcome.output.find(" 0 of them"), std::string::npos) << outcome.output;
  const Files resumed = files();
  fs::remove_all(out());
  EXPECT_EQ(sweep("", scene).status, 0);
  EXPECT_EQ(files(), resumed);
}

TEST_F(Sweeps, CasesWithoutASolutionAreListedAndTheOthersGoOn) {
  const std::string scene = good_scene + "sweep { kernel { width \"0.1 40\" } }";
  const std::string expected =
      "microslip: 1 of 2 cases have no solution, the first is case 1 of 2 (kernel.width = 0.1): ";
  // With `known_edge`, it is already missing when the scene is read.
  for (const char* method : {"leading_edge=known_edge", "method=chebyshev"}) {
    fs::remove_all(out());
    for (int again = 0; again < 2; ++again) {
      const Outcome outcome = sweep("--tables --set " + std::string(method), scene);
      EXPECT_EQ(outcome.status, 2);
      EXPECT_EQ(outcome.error.substr(0, expected.size()), expected);
      EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    }
    const auto status = column(out() / "sweep.tsv", "status");
    ASSERT_EQ(status.size(), 2U);
    EXPECT_NE(status[0].find("64 unknowns do not suffice"), std::string::npos) << status[0];
    EXPECT_EQ(status[1], "ok");
    EXPECT_EQ(column(out() / "sweep.tsv", "force")[0], "nan");
    EXPECT_LT(std::stod(column(out() / "sweep.tsv", "force")[1]), 0);
  }
  EXPECT_FALSE(fs::exists(out() / "cases" / "1"));
  EXPECT_EQ(merge().status, 2);
}

TEST_F(Sweeps, TransientsAndListsOfNumbers) {
  const std::string scene =
      good_transient + "sweep { step { ratio \"1 | 1 0.5\"\n scheme \"remembered direct\" } }";
  const Outcome outcome = sweep("--tables", scene);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(column(out() / "sweep.tsv", "step.ratio"),
            (std::vector<std::string>{"1", "1", "1 0.5", "1 0.5"}));
  const auto steps = column(out() / "cases" / "3" / "history.tsv", "q");
  EXPECT_EQ(std::to_string(steps.size() - 1), column(out() / "sweep.tsv", "steps")[2]);
}

TEST_F(Sweeps, MergeSaysWhatIsMissing) {
  ASSERT_EQ(sweep("--shard 2/3").status, 0);
  const Files before = files();
  const Outcome outcome = merge();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.error, "microslip: " + out().string() +
                               ": 12 of 18 cases are missing, the first is case 1 of 18 "
                               "(leading_edge = calibrated, grid.elements = 15, load.creepage = "
                               "0.1)\n");
  EXPECT_EQ(files(), before);
  fs::remove_all(out());
  EXPECT_EQ(merge().error,
            "microslip: --out " + out().string() + ": expected a sweep; there is no plan.tsv\n");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Sweeps, AFolderBelongsToOneSweep) {
  ASSERT_EQ(sweep().status, 0);
  expect_rejected("--set kernel.width=30", "holds another sweep; its plan.tsv has '#   kernel.wid");
  expect_rejected("--set 'sweep.load.creepage=0.1 0.2'", "holds another sweep");
  expect_rejected("--shard 1/2 --set sweep.load.creepage=", "holds another sweep");
  fs::copy_file(case_file("02"), case_file("01"), fs::copy_options::overwrite_existing);
  expect_rejected("", "01.tsv: not a case of this sweep");
  const Outcome outcome = merge();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("01.tsv: not a case of this sweep"), std::string::npos);
}

TEST_F(Sweeps, AChangedFileMakesAnotherSweep) {
  const std::string options = "--set contact.peak_traction= --set contact.bound_file='" +
                              (folder_ / "bound.tsv").string() +
                              "' --set sweep.leading_edge= --set leading_edge=standard";
  std::ofstream(folder_ / "bound.tsv") << "x\tbound\n0\t1\n";
  const Outcome outcome = sweep(options);
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  std::ofstream(folder_ / "bound.tsv") << "x\tbound\n0\t1.5\n";
  expect_rejected(options, "holds another sweep; its plan.tsv has '#   checksum of bound.tsv");
}

TEST_F(Sweeps, BadInput) {
  expect_rejected("", "missing section 'sweep'", good_scene);
  expect_rejected("--set sweep.load.creepage=0:log3:1",
                  "sweep.load.creepage = '0:log3:1': expected first:step:last");
  expect_rejected("--set sweep.grid.elemnts=3", "unknown key 'grid.elemnts'");
  expect_rejected("--set 'sweep.grid.elements=20 0'",
                  "case 4 of 12 (leading_edge = calibrated, grid.elements = 0, load.creepage = "
                  "0.1): grid.elements = 0: expected");
  expect_rejected("--set 'sweep.leading_edge=standard sharp'", "leading_edge = 'sharp': expected");
  expect_rejected(
      "--set contact.roughness=10 --set leading_edge=calibrated --set load.creepage=0.1 "
      "--set grid.elements=50 --set 'sweep.contact.peak_traction=1 1e50'",
      "case 2 of 2 (contact.peak_traction = 1e50): largest of contact.roughness = 1.");
  expect_rejected("--threads 0", "--threads '0': expected a whole number from 1");
  expect_rejected("--threads many", "--threads 'many': expected");
  for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "1/0", "a/b", "-1/2", "1/2/3"}) {
    expect_rejected(std::string("--shard ") + shard,
                    "--shard '" + std::string(shard) + "': expected i/n with i from 1 to n");
  }
  expect_rejected("--quick", "--quick");
  const Outcome outcome = run_program("microslip", "", good_sweep, "");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("key 'sweep.leading_edge': expected a scene without a sweep"),
            std::string::npos)
      << outcome.error;
}

TEST_F(Sweeps, KeysTogetherAndTablesAreTheCasesOfTheirRows) {
  const std::string together =
      good_scene +
      "sweep { together { contact { half_width \"1 2\"\n peak_traction \"3 1.5\" } }\n"
      "load { creepage \"0.1 0.2\" } }";
  ASSERT_EQ(sweep("", together).error, "");
  const auto columns = [&](const char* name) { return column(out() / "sweep.tsv", name); };
  EXPECT_EQ(columns("contact.half_width"), (std::vector<std::string>{"1", "1", "2", "2"}));
  EXPECT_EQ(columns("contact.peak_traction"), (std::vector<std::string>{"3", "3", "1.5", "1.5"}));
  const auto forces = columns("force");
  fs::remove_all(out());

  std::ofstream(folder_ / "cases.tsv") << "contact.half_width [m] contact.peak_traction\n"
                                          "0.001 3\n0.002 1.5\n";
  const std::string by_table =
      good_scene + "sweep { table cases.tsv\n load { creepage \"0.1 0.2\" } }";
  ASSERT_EQ(sweep("", by_table).error, "");
  EXPECT_EQ(columns("force"), forces);
  EXPECT_NE(text_of(out() / "plan.tsv").find("checksum of cases.tsv"), std::string::npos);

  // The plan of a sweep is a table of cases for another one.
  fs::copy_file(out() / "plan.tsv", folder_ / "plan.tsv");
  fs::remove_all(out());
  ASSERT_EQ(sweep("", good_scene + "sweep { table plan.tsv }").error, "");
  EXPECT_EQ(columns("force"), forces);
}

TEST_F(Sweeps, BadGroupsAndTables) {
  expect_rejected("--set 'sweep.together.kernel.width=1 2' --set 'sweep.together.load.force=1'",
                  "sweep.together.load.force = '1': expected as many values as kernel.width has");
  const std::string by_table = good_scene + "sweep { table cases.tsv }";
  expect_rejected("", "cases.tsv", by_table);
  std::ofstream(folder_ / "cases.tsv") << "kernel.width\tforce\n1\t2\n";
  expect_rejected(
      "",
      "scene.info:10: sweep.table = 'cases.tsv': column 'force': expected the name of a "
      "key",
      by_table);
  std::ofstream(folder_ / "cases.tsv") << "kernel.width grid.elements\n40 20\n40 many\n";
  expect_rejected("",
                  "case 2 of 2 (kernel.width = 40, grid.elements = many): grid.elements = 'many': "
                  "expected a whole number",
                  by_table);
}

// On a terminal, which `script` provides: how far the cases that run are, and which have failed.
TEST_F(Sweeps, ProgressIsThatOfTheCasesThatRun) {
  if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "no script";
  std::ofstream(scene_file()) << good_transient;
  const std::string output =
      run_command("cd '" + folder_.string() +
                  "' && script -qec \"timeout -s INT 5 " MICROSLIP_BIN
                  "/microslip sweep scene.info --threads 1 --set grid.elements=2001 --set "
                  "motion.distance=4 --set step.ratio=0.01 --set 'sweep.load.force=-1 -1.1 "
                  "-1.2'\" /dev/null")
          .output;
  EXPECT_NE(output.find("microslip: 0 of 3, "), std::string::npos) << output;
  EXPECT_NE(output.find(" left; case 1 at "), std::string::npos) << output;
}

TEST_F(Sweeps, TheJobArrayIsTheSameSweep) {
  ASSERT_EQ(sweep().status, 0);
  const Files once = files();
  fs::remove_all(out());
  const auto task = [&](int id) {
    return run_command(
        "SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=1 "
        "MICROSLIP='" MICROSLIP_BIN "/microslip' SLURM_ARRAY_TASK_ID=" +
        std::to_string(id) + " bash '" MICROSLIP_SOURCE "/studies/sweep.sbatch' '" +
        scene_file().string() + "' '" + out().string() + "'");
  };
  for (const int id : {2, 0, 1}) {
    const Outcome outcome = task(id);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.output, done("microslip: 6 cases, 0 of them finished before"));
  }
  EXPECT_EQ(merge().status, 0);
  EXPECT_EQ(files(), once);
}

TEST_F(Sweeps, AnUnwritableFolderLeavesNothing) {
  std::ofstream(out()) << "a file where a folder should be";
  const Outcome outcome = sweep();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_TRUE(fs::is_regular_file(out()));
}

}  // namespace microslip::sweeps_test
