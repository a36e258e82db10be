// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of an ellipse as they are typed: the scene of `init`, its figures, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "robustness/executables.hpp"

namespace microslip::patch_steps_test {

class PatchSteps : public Executables {
 protected:
  void SetUp() override {
    Executables::SetUp();
    run_in_folder("init ellipse_transient");
  }

  Outcome solve(const std::string& words) const {
    return run_in_folder("ellipse_transient.info --quiet --set grid.rows=6 --set grid.elements=8 " +
                         words);
  }

  /// \param error  behind the program's name
  void expect_refused(const std::string& words, const std::string& error) const {
    const Outcome outcome = solve(words);
    EXPECT_EQ(outcome.status, 1) << words;
    EXPECT_EQ(outcome.error.find("microslip: " + error), 0U) << outcome.error;
    EXPECT_FALSE(fs::exists(folder_ / "out")) << words;
  }
};

TEST_F(PatchSteps, HaveTablesAndFigures) {
  const Outcome solved = solve("");
  EXPECT_EQ(solved.status, 0);
  EXPECT_EQ(solved.error, "");
  const std::string history = text_of(folder_ / "out" / "history.tsv");
  EXPECT_NE(
      history.find("\nq\tforce\tlateral_force\tspin_moment\tcreepage\tlateral_creepage\tspin\t"),
      std::string::npos);
  EXPECT_NE(text_of(folder_ / "out" / "summary.tsv").find("\nwarning\tnone"), std::string::npos);
  EXPECT_EQ(run_in_folder("plot out").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out.svg"));
  EXPECT_TRUE(fs::exists(folder_ / "out_ellipse.svg"));
  ASSERT_EQ(solve("--set step.scheme=direct --out direct").status, 0);
  EXPECT_EQ(run_in_folder("plot direct --figure ellipse --to map.svg").status, 0);
  EXPECT_EQ(run_in_folder("plot out direct --q 0:20 --to both.svg").status, 0);
  EXPECT_EQ(run_in_folder("plot out --x 0:1").error,
            "microslip: --x: expected a line contact, a sweep or a curve with it\n");
  EXPECT_EQ(
      run_in_folder("plot out --over t").error.find("microslip: --over t: 'out' has no times"), 0U);
}

TEST_F(PatchSteps, FollowARun) {
  std::ofstream(folder_ / "run.csv")
      << "t [ms];v [m/s];creepage [%];lateral_force [kN];spin [1/m]\n"
         "0;1;0;0;0\n2;2;0.1;1;0.1\n10;2;0.1;-1;0.1\n";
  const Outcome solved = solve(
      "--set load.force= --set load.lateral_force= --set load.spin= --set load.file=run.csv --set "
      "motion.distance= --set start.type=rest --set step.ratio=2");
  EXPECT_EQ(solved.status, 0) << solved.error;
  const std::string history = text_of(folder_ / "out" / "history.tsv");
  EXPECT_NE(history.find("iterations\tt\n"), std::string::npos) << history;
  EXPECT_EQ(run_in_folder("plot out --over t --figure history").status, 0);
}

/// A table without its comments.
std::string rows_of(const std::string& text) {
  return text.substr(text.find("\n" + std::string("q\t")));
}

// The first part ends with a step: 11 times half of the mean element.
TEST_F(PatchSteps, ContinueFromASavedState) {
  std::ofstream(folder_ / "run.csv") << "q;force [kN];friction\n0;-10;0.3\n9;-5;0.2\n18;-8;0.3\n";
  const std::string run =
      "--set load.force= --set load.file=run.csv --set step.ratio=0.5 --set motion.distance=";
  ASSERT_EQ(solve(run + "18 --out whole").status, 0);
  const Outcome first = solve(run + "9.1801068193 --save half.state --out first");
  ASSERT_EQ(first.status, 0) << first.error;
  const Outcome second =
      solve(run + "18 --set start.type=state --set start.state=half.state --out second");
  ASSERT_EQ(second.status, 0) << second.error;
  const std::string traction = text_of(folder_ / "whole" / "traction.tsv");
  const std::string again = text_of(folder_ / "second" / "traction.tsv");
  EXPECT_EQ(again.substr(again.find("\nx\t")), traction.substr(traction.find("\nx\t")));
  std::string head = rows_of(text_of(folder_ / "first" / "history.tsv"));
  std::string tail = rows_of(text_of(folder_ / "second" / "history.tsv"));
  const std::string all = rows_of(text_of(folder_ / "whole" / "history.tsv"));
  for (int line = 0; line < 2; ++line) tail.erase(0, tail.find('\n', 1));
  EXPECT_EQ(head.substr(0, head.size() - 1) + tail, all);
  EXPECT_EQ(text_of(folder_ / "second" / "summary.tsv").find("\nchange"), std::string::npos);
  std::ofstream(folder_ / "bad.state") << "no state\n";
  const Outcome bad = solve("--set start.type=state --set start.state=bad.state --out third");
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.error.find("start.state = 'bad.state': "), std::string::npos) << bad.error;
  const Outcome other =
      solve("--set grid.rows=7 --set start.type=state --set start.state=half.state --out third");
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.error.find("half.state"), std::string::npos) << other.error;
  EXPECT_NE(other.error.find("grid.rows"), std::string::npos) << other.error;
}

TEST_F(PatchSteps, AreSwept) {
  EXPECT_EQ(
      run_in_folder("sweep ellipse_transient.info --quiet --set grid.rows=5 --set "
                    "grid.elements=6 --set motion.distance=4 --set 'sweep.load.spin=0 0.2 1/m' "
                    "--set 'sweep.start.type=rest cattaneo' --out s")
          .status,
      0);
  EXPECT_NE(text_of(folder_ / "s" / "sweep.tsv").find("spin_moment"), std::string::npos);
}

TEST_F(PatchSteps, AreRefusedInOneLineThatNamesTheKey) {
  expect_refused("--set step.ratio=-1", "step.ratio = -1: expected numbers >= 1e-15 or 0; bodies");
  expect_refused("--set motion.distance=0", "motion.distance = 0: expected");
  expect_refused("--set load.force=30kN", "load.force = 30000: expected less than full sliding");
  expect_refused("--set load.force= --set load.creepage=1e9",
                 "load.creepage = 1e+09: expected at most ");
  expect_refused("--set start.lateral_force=1e6",
                 "start.lateral_force = 1e+06: expected less than full sliding, 24000 N");
  expect_refused("--set start.state=x --set start.type=state", "start.state = 'x': ");
  expect_refused("--set cylinder.mass=1", "key 'cylinder.mass' has no role here");
  expect_refused("--set step.scheme=direct --save x",
                 "step.scheme = 'direct': expected remembered with --save");
  std::ofstream(folder_ / "back.tsv") << "q\tcreepage\n0\t-0.001\n-6\t-0.001\n";
  expect_refused(
      "--set start.type=rest --set load.force= --set load.lateral_force= --set load.spin= --set "
      "motion.distance= --set load.file=back.tsv --set step.scheme=direct",
      "load.file = 'back.tsv': step.scheme = 'direct': expected remembered, which alone rolls "
      "back");
  for (const char* command : {"curve", "response"}) {
    const Outcome outcome = run_in_folder(std::string(command) + " ellipse_transient.info");
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  }
  EXPECT_EQ(run_in_folder("ellipse_transient.info --quiet --set load.force_ratio=0.9 --set "
                          "load.force= --set load.spin= --set load.spin_moment_ratio=0.9")
                .status,
            2);
}

TEST_F(PatchSteps, LoseTheirContactAndAreDrawn) {
  const std::string contact =
      "--set load.force= --set load.spin= --set load.file=run.csv --set motion.distance= --set "
      "start.type=rest --set step.ratio=1 ";
  const auto run = [&](const std::string& rows) {
    std::ofstream(folder_ / "run.csv") << "q;creepage [%];lateral_force [kN];normal_load [kN]\n"
                                       << rows;
    return solve("--set load.lateral_force= " + contact);
  };
  const Outcome solved = run("0;0.1;0;80\n8;0.1;0;0\n12;0.1;0;0\n20;0.1;1;80\n");
  EXPECT_EQ(solved.status, 0) << solved.error;
  EXPECT_EQ(run_in_folder("plot out").status, 0);
  const Outcome lost = run("0;0.1;0;80\n8;0.1;0;0\n12;0.1;0;0\n");
  EXPECT_EQ(lost.status, 0) << lost.error;
  const std::string tables = text_of(folder_ / "out" / "summary.tsv") +
                             text_of(folder_ / "out" / "history.tsv") +
                             text_of(folder_ / "out" / "traction.tsv");
  EXPECT_EQ(tables.find("nan"), std::string::npos);
  EXPECT_EQ(
      run_in_folder("plot out --figure ellipse --to map.svg").error,
      "microslip: 'out': expected the folder of a result; it ends without contact, and has no "
      "map\n");
  EXPECT_EQ(run_in_folder("plot out").status, 0);
  fs::remove_all(folder_ / "out");
  const Outcome held = run("0;0.1;0;80\n8;0.1;1;0\n12;0.1;1;80\n");
  EXPECT_EQ(held.status, 1);
  EXPECT_NE(held.error.find("row 2: lateral_force = 1000: expected 0 where bodies do not touch, or "
                            "have no friction\n"),
            std::string::npos)
      << held.error;
  EXPECT_EQ(std::count(held.error.begin(), held.error.end(), '\n'), 1) << held.error;
  run("0;0.1;0;80\n8;0.1;0;0\n12;0.1;0;0\n");
  const Outcome told =
      run_in_folder("explain ellipse_transient.info --set load.lateral_force= " + contact);
  const Outcome converge =
      run_in_folder("converge ellipse_transient.info --set load.lateral_force= " + contact);
  EXPECT_EQ(converge.status, 1);
  EXPECT_NE(
      converge.error.find("load.file = 'run.csv': expected rows in which an ellipse keeps its "
                          "contact"),
      std::string::npos)
      << converge.error;
  EXPECT_NE(
      told.output.find("in 2 rows of load.file contact or friction is lost, first at q = 8 mm"),
      std::string::npos)
      << told.output;
}

TEST_F(PatchSteps, ConvergeOnRowsThatFit) {
  const std::string few = " --elements '5 8' --set motion.distance='5 mm'";
  const Outcome outcome =
      run_in_folder("converge ellipse_transient.info --step-time '1 s' --out converged" + few);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 2) << outcome.output;
  EXPECT_TRUE(outcome.output.starts_with("for an error of 0.001 in the forces (over full sliding)"))
      << outcome.output;
  EXPECT_NE(outcome.output.find("within 1 s a step: remembered with grid.rows "), std::string::npos)
      << outcome.output;
  const std::string table = text_of(folder_ / "converged" / "converge.tsv");
  EXPECT_NE(table.find("\nremembered\t8\t"), std::string::npos) << table;
  EXPECT_NE(table.find("\ndirect\t8\t"), std::string::npos) << table;
  EXPECT_EQ(run_in_folder("plot converged --to a.svg").output, "drew a.svg\n");
  run_in_folder("ellipse_transient.info --quiet --save state --set motion.distance='5 mm'");
  const Outcome continued = run_in_folder(
      "converge ellipse_transient.info --set start.type=state --set start.state=state");
  EXPECT_EQ(continued.status, 1);
  EXPECT_NE(continued.error.find("start.type = 'state': expected another start"), std::string::npos)
      << continued.error;
}

}  // namespace microslip::patch_steps_test
