// SPDX-License-Identifier: GPL-3.0-or-later
// Tests faults that are not in the input: signals, full disks, folders that are none, others who
// write to the same folder. There is one line, a fitting exit status, and in the folder all of one
// run.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/types.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <thread>
#include <vector>

#include "microslip/support/shown.hpp"
#include "robustness/executables.hpp"

namespace microslip::faults_test {

using namespace std::chrono_literals;
using Files = std::map<std::string, std::string>;

const std::string microslip_bin = std::string(MICROSLIP_BIN) + "/microslip";
const std::string carter_bin = std::string(MICROSLIP_BIN) + "/carter";

/// Half a second of work, and many minutes.
const std::string slow_options =
    "--set grid.elements=1000 --set step.ratio=0.1 --set motion.distance=1.5";
const std::string endless_options =
    "--set grid.elements=1000 --set step.ratio=0.01 --set motion.distance=10";

const std::string small_sweep = good_scene + "sweep { grid { elements \"10:1:30\" } }\n";

class Faults : public Executables {
 protected:
  void SetUp() override {
    Executables::SetUp();
    std::ofstream(scene_file()) << good_scene;
  }

  std::string solve(const std::string& options = "") const {
    return microslip_bin + " --scene '" + scene_file().string() + "' --out '" + out().string() +
           "' " + options;
  }

  /// All files of a folder, hidden ones too, except for what differs from run to run in
  /// provenance.txt.
  static Files files_in(const fs::path& folder) {
    Files all;
    if (!fs::exists(folder)) return all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      const std::string name = fs::relative(entry.path(), folder);
      all[name] = name.starts_with("provenance") ? "" : text_of(entry.path());
    }
    return all;
  }

  Files files() const { return files_in(out()); }

  /// Returns the files that a run leaves in an empty folder.
  Files files_of(const std::string& command) const {
    fs::remove_all(out());
    EXPECT_EQ(run_command(command).status, 0) << command;
    return files();
  }

  static void expect_line(const Outcome& outcome, int status, const std::string& named) {
    EXPECT_EQ(outcome.status, status) << named;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(": " + named), std::string::npos) << outcome.error;
  }

  static std::string in_a_shell(const std::string& commands) {
    std::string all = "(";
    return all.append(commands).append(")");
  }

  /// Starts a command that `exec`s a program; to be waited for by `status_of`.
  pid_t start(const std::string& command) const {
    const pid_t child = fork();
    if (child == 0) {
      const std::string all = "exec " + command + " 2>'" + (folder_ / "stderr").string() + "'";
      execl("/bin/sh", "sh", "-c", all.c_str(), nullptr);
      _exit(99);
    }
    return child;
  }

  /// Until a run takes signals, in a thread of its own.
  static void wait_for_work(pid_t run) {
    const fs::path threads = "/proc/" + std::to_string(run) + "/task";
    std::error_code ended;
    while (std::distance(fs::directory_iterator(threads, ended), {}) == 1) {
      std::this_thread::sleep_for(1ms);
    }
  }

  /// 128 + signal for one that a signal ended, as in a shell.
  static int status_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  static std::vector<int> statuses_of(const std::vector<pid_t>& processes) {
    std::vector<int> statuses;
    for (const pid_t process : processes) statuses.push_back(status_of(process));
    return statuses;
  }

  /// A shell that is root in its own world of mounts, where that is allowed.
  bool can_mount() const { return run_command("unshare -rm mount -t tmpfs none /mnt").status == 0; }

  /// Runs commands with a file system of its own in `out`, and then prints what is in that.
  Outcome run_mounted(const std::string& options, const std::string& commands) const {
    fs::create_directories(out());
    std::ofstream(folder_ / "mounted.sh")
        << "mount -t tmpfs -o " << options << " none '" << out().string() << "' || exit 99\n"
        << commands << "\nstatus=$?\nls -A '" << out().string() << "'\nexit $status\n";
    return run_command("unshare -rm sh '" + (folder_ / "mounted.sh").string() + "'");
  }
};

TEST_F(Faults, SignalsEndARunWithOneLineAndNoFile) {
  std::ofstream(scene_file()) << good_transient;
  const std::string study = carter_bin + " --set grid.elements=4000 --out '" + out().string() + "'";
  const std::map<int, int> statuses{{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}};
  for (const auto& [signal, status] : statuses) {
    for (const std::string& command : {solve(endless_options), study}) {
      const pid_t run = start(command);
      wait_for_work(run);
      kill(run, signal);
      EXPECT_EQ(status_of(run), status) << command;
      const std::string name = command == study ? "carter" : "microslip";
      EXPECT_EQ(text_of(folder_ / "stderr"), name + ": interrupted, nothing is written\n");
      EXPECT_FALSE(fs::exists(out()));
    }
  }
}

TEST_F(Faults, AnIgnoredSignalStaysIgnored) {
  std::ofstream(scene_file()) << good_transient;
  std::ofstream(folder_ / "ignore.sh") << "trap '' INT HUP\nexec " << solve(slow_options) << '\n';
  const pid_t run = start("sh '" + (folder_ / "ignore.sh").string() + "'");
  wait_for_work(run);
  kill(run, SIGHUP);
  kill(run, SIGINT);
  EXPECT_EQ(status_of(run), 0);
  EXPECT_TRUE(fs::exists(out() / "provenance.txt"));
}

TEST_F(Faults, SignalsAtAnyTimeLeaveAllOfOneRun) {
  const std::string other = solve("--set load.creepage=0.2");
  const Files two = files_of(other);
  const Files one = files_of(solve());
  ASSERT_NE(one, two);
  int through = 0;
  for (auto delay = 0us; through < 5; delay += 250us + delay / 16) {
    const pid_t run = start(other);
    std::this_thread::sleep_for(delay);
    kill(run, SIGTERM);
    const int status = status_of(run);
    if (status == 0) ++through;
    EXPECT_TRUE(status == 0 || status == 143) << status;
    const Files left = files();
    ASSERT_TRUE(left == two || (left == one && status != 0)) << delay.count() << " us";
    if (left == two) {
      ASSERT_EQ(files_of(solve()), one);
    }
  }
}

TEST_F(Faults, AKilledRunLeavesNoProvenanceWithTablesOfTwo) {
  const std::string other = solve("--set load.creepage=0.2");
  const Files two = files_of(other);
  const Files one = files_of(solve());
  int through = 0;
  for (auto delay = 0us; through < 5; delay += 250us + delay / 16) {
    const pid_t run = start(other);
    std::this_thread::sleep_for(delay);
    kill(run, SIGKILL);
    if (status_of(run) == 0) ++through;
    Files left = files();
    std::erase_if(left, [](const auto& file) { return file.first.starts_with('.'); });
    ASSERT_TRUE(left == one || left == two || left.count("provenance.txt") == 0)
        << delay.count() << " us";
    if (left != one) {
      ASSERT_EQ(files_of(solve()), one);
    }
  }
}

TEST_F(Faults, ADiskThatIsFullAtStandardOutput) {
  const std::string full = "cannot write to standard output: No space left on device\n";
  for (const std::string& command :
       {microslip_bin + " --help", carter_bin + " --version", carter_bin + " --print-scene",
        microslip_bin + " merge --help", microslip_bin + " sweep --version"}) {
    expect_line(run_command(in_a_shell(command + " >/dev/full")), 1, full);
    expect_line(run_command(in_a_shell(command + " >&-")), 1,
                "cannot write to standard output: Bad file descriptor\n");
  }
}

TEST_F(Faults, AReaderThatHasGone) {
  const Outcome outcome = run_command("bash -c 'set -o pipefail; (sleep 0.2; exec " +
                                      microslip_bin + " --help) | true'");
  expect_line(outcome, 1, "cannot write to standard output: Broken pipe\n");
}

TEST_F(Faults, AMessageThatCannotBeWrittenChangesNoStatusAndNoTable) {
  for (const char* redirection : {"2>/dev/full", "2>&-", "<&- >&- 2>&-"}) {
    EXPECT_EQ(run_command(in_a_shell(solve("--set grid.elements=0 ") + redirection)).status, 1);
    EXPECT_FALSE(fs::exists(out()));
  }
  const Files once = files_of(solve());
  for (const char* redirection : {"2>/dev/full", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    EXPECT_EQ(files_of(in_a_shell(solve(redirection))), once) << redirection;
  }
}

TEST_F(Faults, FilesThatBecomeTooLarge) {
  const std::string limited = in_a_shell("ulimit -f 1; " + solve("--set grid.elements=100"));
  const std::string named =
      "cannot write " + (out() / "traction.tsv").string() + ": File too large";
  expect_line(run_command(limited), 1, named);
  EXPECT_FALSE(fs::exists(out()));
  const Files before = files_of(solve());
  expect_line(run_command(limited), 1, named);
  EXPECT_EQ(files(), before);
  fs::remove_all(out());
  std::ofstream(scene_file()) << small_sweep;
  expect_line(run_command("(ulimit -f 1; " + microslip_bin + " sweep --scene '" +
                          scene_file().string() + "' --out '" + out().string() + "/a/b')"),
              1, "cannot write " + (out() / "a" / "b" / "plan.tsv").string() + ": File too large");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Faults, ADiskThatIsFull) {
  if (!can_mount()) GTEST_SKIP() << "needs a file system of its own";
  const Outcome study = run_mounted("size=32k", carter_bin + " --out '" + out().string() + "/new'");
  expect_line(
      study, 1,
      "cannot write " + (out() / "new" / "exact.tsv").string() + ": No space left on device");
  EXPECT_EQ(study.output, "");
  const Outcome again = run_mounted(
      "size=32k", solve() + " --quiet && cp -r '" + out().string() + "' '" + folder_.string() +
                      "/kept' && { " + carter_bin + " --out '" + out().string() + "'; diff -r '" +
                      out().string() + "' '" + folder_.string() + "/kept'; }");
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_EQ(again.output, "provenance.txt\nsummary.tsv\ntraction.tsv\n");
}

TEST_F(Faults, ASweepGoesOnWhenTheDiskHasRoomAgain) {
  if (!can_mount()) GTEST_SKIP() << "needs a file system of its own";
  const std::string sweep = microslip_bin + " sweep --threads 2 --scene '" + scene_file().string() +
                            "' --out '" + out().string() + "'";
  std::ofstream(scene_file()) << small_sweep;
  const Files once = files_of(sweep);
  const std::string full = sweep + " 2>'" + (folder_ / "full").string() +
                           "'; test $? = 1 && mount -o remount,size=10m '" + out().string() +
                           "' && ";
  const Outcome outcome = run_mounted("size=64k", full + sweep + " && cp -r '" + out().string() +
                                                      "' '" + folder_.string() + "/kept'");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(text_of(folder_ / "full").find("No space left on device\n"), std::string::npos);
  EXPECT_EQ(outcome.output.find(" 0 of them"), std::string::npos) << outcome.output;
  EXPECT_EQ(files_in(folder_ / "kept"), once);
}

TEST_F(Faults, AFileSystemForReadingOnly) {
  if (!can_mount()) GTEST_SKIP() << "needs a file system of its own";
  const Outcome outcome = run_mounted("ro", solve());
  expect_line(outcome, 1, "cannot write " + out().string() + ": Read-only file system\n");
}

TEST_F(Faults, FoldersThatAreNone) {
  std::ofstream(folder_ / "file") << "a file";
  fs::create_symlink(folder_ / "nowhere", folder_ / "dangling");
  const std::string folder = folder_.string();
  const std::map<std::string, std::string> reasons{
      {folder + "/file", folder + "/file is not a folder"},
      {folder + "/file/below", folder + "/file is not a folder"},
      {folder + "/dangling", folder + "/dangling is not a folder"},
      {folder + "/dangling/below", folder + "/dangling is not a folder"},
      {"/proc/none/below", "No such file or directory"},
      {folder + "/" + std::string(300, 'x'), "File name too long"},
      {folder + std::string(3000, '/') + std::string(1200, 'x'), "File name too long"},
      {"/dev/null", "/dev/null is not a folder"}};
  const Files before = files_in(folder_);
  for (const auto& [path, reason] : reasons) {
    const std::string options = " --scene '" + scene_file().string() + "' --out '" + path + "'";
    expect_line(run_command(microslip_bin + options), 1,
                "cannot write " + shown(path) + ": " + reason);
    EXPECT_EQ(
        run_command(microslip_bin + " sweep --set 'sweep.grid.elements=10 20'" + options).status,
        1);
  }
  Files after = files_in(folder_);
  after.erase("stdout"), after.erase("stderr");
  EXPECT_EQ(after, before);
  expect_line(run_command(microslip_bin + " --scene '" + scene_file().string() + "' --out ''"), 1,
              "--out '': expected the name of a folder\n");
}

TEST_F(Faults, AFolderThatIsNoneIsFoundBeforeTheWork) {
  std::ofstream(out()) << "a file";
  const std::string unsolvable = solve("--set method=chebyshev --set kernel.width=0.1");
  expect_line(run_command(unsolvable), 1, "cannot write " + out().string());
  fs::remove(out());
  EXPECT_EQ(run_command(unsolvable).status, 2);
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Faults, AFolderThatVanishesIsMadeAgain) {
  std::ofstream(scene_file()) << good_transient;
  const std::string slow = solve(slow_options);
  const Files once = files_of(slow);
  const pid_t run = start(slow);
  wait_for_work(run);
  std::this_thread::sleep_for(100ms);  // until it has looked whether it can write there
  fs::remove_all(out());
  EXPECT_EQ(status_of(run), 0);
  EXPECT_EQ(files(), once);
  fs::remove_all(out());
  const std::string gone = (folder_ / "gone").string();
  expect_line(run_command("(mkdir '" + gone + "' && cd '" + gone + "' && rmdir '" + gone + "' && " +
                          microslip_bin + " --scene '" + scene_file().string() + "' --out below)"),
              1, "cannot write below: No such file or directory\n");
}

TEST_F(Faults, AFolderInThePlaceOfATableLeavesTheOthers) {
  for (const char* name : {"provenance.txt", "traction.tsv"}) {
    files_of(solve());
    fs::remove(out() / name);
    fs::create_directory(out() / name);
    const Files before = files();
    expect_line(run_command(solve("--set load.creepage=0.2")), 1,
                "cannot write " + (out() / name).string() + ": Is a directory\n");
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(fs::is_directory(out() / name));
    fs::remove_all(out());
  }
}

TEST_F(Faults, OfRunsIntoOneFolderOneIsThereWhole) {
  const std::string other = solve("--set load.creepage=0.2 --set grid.elements=200");
  const Files two = files_of(other);
  const Files one = files_of(solve());
  for (int round = 0; round < 15; ++round) {
    fs::remove_all(out());
    std::vector<pid_t> runs;
    for (int k = 0; k < 12; ++k) runs.push_back(start(k % 2 == 0 ? solve() : other));
    EXPECT_EQ(statuses_of(runs), std::vector<int>(runs.size(), 0)) << text_of(folder_ / "stderr");
    const Files left = files();
    ASSERT_TRUE(left == one || left == two) << round;
  }
}

TEST_F(Faults, TablesOfAnEarlierRunGoWithIt) {
  const Files steady = files_of(solve());
  std::ofstream(folder_ / "transient.info") << good_transient;
  const std::string transient = microslip_bin + " --scene '" +
                                (folder_ / "transient.info").string() + "' --out '" +
                                out().string() + "'";
  Files both = files_of(transient);
  EXPECT_EQ(both.count("history.tsv"), 1U);
  std::ofstream(out() / "notes.tsv") << "not of a run";
  EXPECT_EQ(run_command(in_a_shell("ulimit -f 1; " + solve())).status, 1);
  both["notes.tsv"] = "not of a run";
  EXPECT_EQ(files(), both);
  EXPECT_EQ(run_command(solve()).status, 0);
  Files left = files();
  EXPECT_EQ(left.extract("notes.tsv").mapped(), "not of a run");
  EXPECT_EQ(left, steady);
}

TEST_F(Faults, ARunWaitsUntilAnotherHasWritten) {
  fs::create_directory(out());
  const int other = open(out().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  const pid_t run = start(solve());
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(files(), Files());
  close(other);
  EXPECT_EQ(status_of(run), 0);
  EXPECT_EQ(files().size(), 3U);
}

TEST_F(Faults, SweepsIntoOneFolderAreOneSweep) {
  std::ofstream(scene_file()) << small_sweep;
  const std::string sweep = microslip_bin + " sweep --quiet --tables --threads 2 --scene '" +
                            scene_file().string() + "' --out '" + out().string() + "'";
  const Files once = files_of(sweep);
  for (int round = 0; round < 5; ++round) {
    fs::remove_all(out());
    std::vector<pid_t> runs;
    for (int k = 0; k < 6; ++k) runs.push_back(start(sweep));
    EXPECT_EQ(statuses_of(runs), std::vector<int>(runs.size(), 0)) << text_of(folder_ / "stderr");
    ASSERT_EQ(files(), once) << round;
  }
}

}  // namespace microslip::faults_test
