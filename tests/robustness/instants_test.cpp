// SPDX-License-Identifier: GPL-3.0-or-later
// Tractions at instants of a run: the tables, beside those of shorter runs, and their pictures.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "robustness/executables.hpp"

namespace microslip::instants_test {

using Rows = std::vector<std::vector<std::string>>;

class Instants : public Executables {
 protected:
  void SetUp() override {
    Executables::SetUp();
    run_in_folder("init transient");
    run_in_folder("init ellipse_transient");
    std::ofstream(folder_ / "times.tsv")
        << "t [s]\tv [mm/s]\tcreepage\thalf_width\n0\t100\t0.001\t5\n0.1\t200\t0.002\t6\n"
           "0.2\t200\t-0.001\t4\n";
    std::ofstream(folder_ / "turns.tsv")
        << "t [s]\tv [mm/s]\tforce\n0\t400\t-100\n0.1\t0\t-100\n0.1\t0\t-20\n0.3\t0\t50\n"
           "0.4\t-300\t50\n";
  }

  void solve(const std::string& words) const {
    const Outcome outcome = run_in_folder(words + " --quiet");
    ASSERT_EQ(outcome.status, 0) << words << outcome.error;
  }

  void expect_refused(const std::string& words, const std::string& error) const {
    const Outcome outcome = run_in_folder(words);
    EXPECT_EQ(outcome.status, 1) << words;
    EXPECT_EQ(outcome.error, "microslip: " + error + "\n") << words;
  }

  /// The rows of a table without its comments; the first has the names of its columns.
  Rows rows(const std::string& table) const {
    Rows found;
    std::ifstream in(folder_ / (table + ".tsv"));
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with('#')) continue;
      found.emplace_back();
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, '\t');) found.back().push_back(cell);
    }
    return found;
  }

  /// Rows of each instant behind the columns of its place, with the names.
  std::map<int, Rows> by_instants(const std::string& table, std::size_t columns) const {
    std::map<int, Rows> found;
    const Rows all = rows(table);
    for (std::size_t i = 1; i < all.size(); ++i) {
      Rows& of = found[std::stoi(all[i][0])];
      const auto behind = static_cast<std::ptrdiff_t>(columns);
      if (of.empty()) of.emplace_back(all[0].begin() + behind, all[0].end());
      of.emplace_back(all[i].begin() + behind, all[i].end());
    }
    return found;
  }

  /// The q of each instant, as it is written.
  std::vector<std::string> places(const std::string& table) const {
    std::map<int, std::string> found;
    const Rows all = rows(table);
    for (std::size_t i = 1; i < all.size(); ++i) found[std::stoi(all[i][0])] = all[i][1];
    std::vector<std::string> texts;
    for (const auto& [instant, q] : found) texts.push_back(q);
    return texts;
  }
};

/// Expects numbers that differ by 1e-12 of the largest of their column, and the same words.
void expect_alike(const Rows& some, const Rows& others, const std::string& what) {
  SCOPED_TRACE(what);
  ASSERT_EQ(some.size(), others.size());
  ASSERT_EQ(some.at(0), others.at(0));
  for (std::size_t c = 0; c < some[0].size(); ++c) {
    const std::string& name = some[0][c];
    if (name == "region" || name == "zone") {
      for (std::size_t i = 1; i < some.size(); ++i) EXPECT_EQ(some[i][c], others[i][c]);
      continue;
    }
    double largest = 0;
    for (std::size_t i = 1; i < some.size(); ++i) {
      largest = std::max(largest, std::abs(std::stod(others[i][c])));
    }
    for (std::size_t i = 1; i < some.size(); ++i) {
      EXPECT_NEAR(std::stod(some[i][c]), std::stod(others[i][c]), 1e-12 * largest) << name << i;
    }
  }
}

const std::string line = "transient.info --set grid.elements=31 ";
const std::string ellipse = "ellipse_transient.info --set grid.rows=5 --set grid.elements=7 ";
const std::string with_times =
    "--set load.force= --set start.type=rest --set load.file=times.tsv --set motion.distance= "
    "--set step.ratio=1 ";
const std::string with_turns =
    "--set load.force= --set start.type=rest --set load.file=turns.tsv --set motion.distance= "
    "--set step.ratio=1 ";

TEST_F(Instants, EndWithTheTractionAtTheEnd) {
  const std::vector<std::pair<std::string, std::size_t>> runs{
      {line, 2},
      {line + "--set step.scheme=direct ", 2},
      {line + "--set step.scheme=fractional ", 2},
      {line + with_times, 3},
      {line + with_turns, 4},
      {ellipse, 2},
      {ellipse + "--set step.scheme=direct ", 2},
      {ellipse + with_times +
           "--set contact.half_width=5 --set contact.lateral_half_width=4 --set "
           "contact.radius_1= --set contact.lateral_radius_2= ",
       3}};
  for (const auto& [run, columns] : runs) {
    solve(run + "--set motion.instants=4");
    const auto instants = by_instants("out/instants", columns);
    ASSERT_EQ(instants.size(), 4U) << run;
    EXPECT_EQ(instants.at(4), rows("out/traction")) << run;
    const bool is_patch = fs::exists(folder_ / "out/edges.tsv");
    ASSERT_EQ(fs::exists(folder_ / "out/instants_edges.tsv"), is_patch) << run;
    if (is_patch) {
      EXPECT_EQ(by_instants("out/instants_edges", columns).at(4), rows("out/edges")) << run;
    }
  }
  EXPECT_EQ(rows("out/instants")[1][2], rows("out/instants")[2][2]) << "the time of an instant";
  solve(line);
  EXPECT_FALSE(fs::exists(folder_ / "out/instants.tsv"));
  EXPECT_FALSE(fs::exists(folder_ / "out/instants_edges.tsv"));
}

// The history, which is written by another way, has a row with the same place and time.
TEST_F(Instants, AreWhereTheHistorySays) {
  for (const std::string& run : std::vector<std::string>{line + with_times, line + with_turns}) {
    solve(run + "--set motion.instants=5");
    const Rows history = rows("out/history"), instants = rows("out/instants");
    const auto column = [](const Rows& table, const std::string& name) {
      return static_cast<std::size_t>(std::ranges::find(table[0], name) - table[0].begin());
    };
    for (std::size_t i = 1; i < instants.size(); ++i) {
      const bool is_there = std::ranges::any_of(history, [&](const auto& row) {
        return row[column(history, "q")] == instants[i][column(instants, "q")] &&
               row[column(history, "t")] == instants[i][column(instants, "t")];
      });
      ASSERT_TRUE(is_there) << run << i;
    }
  }
}

TEST_F(Instants, AreTheEndsOfShorterRuns) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  for (const std::string& run :
       {line, line + "--set step.scheme=direct ", ellipse, ellipse + "--set step.scheme=direct "}) {
    const std::string steps =
        fmt::format("--set step.ratio='{:.3f} {:.3f}' ", 0.5 + part(random), 0.5 + part(random));
    const std::string at = fmt::format("{:.3f} {:.3f}", 1 + 3 * part(random), 5 + 4 * part(random));
    solve(run + steps + "--set motion.distance=12 --set motion.instants_at='" + at + " 12'");
    const auto instants = by_instants("out/instants", 2);
    const std::vector<std::string> ends = places("out/instants");
    ASSERT_EQ(instants.size(), 3U);
    for (std::size_t k = 0; k < 2; ++k) {
      solve(run + steps + "--set motion.distance=" + ends[k] + " --out shorter");
      expect_alike(instants.at(static_cast<int>(k) + 1), rows("shorter/traction"), run + ends[k]);
    }
    EXPECT_NE(instants.at(1), instants.at(2));
  }
}

// The instant 0 is the start, which a state of the run at 0 has, too: the tractions of the shift.
TEST_F(Instants, BeginWithTheStart) {
  solve(line + "--set 'start.force=-1500 500' --set motion.instants_at='0 20'");
  const auto instants = by_instants("out/instants", 2);
  double force = 0;
  const Rows& start = instants.at(1);
  for (std::size_t i = 1; i < start.size(); ++i) force += std::stod(start[i][2]);
  EXPECT_NEAR(force * 10 / 31, 500, 10) << "the sum over elements, in the place of the integral";
}

TEST_F(Instants, OfARunInPartsAreThoseOfTheWhole) {
  for (const std::string& run : {line, ellipse}) {
    solve(run + "--set motion.distance=10 --set motion.instants_at='2 4 7 10' --out whole");
    const std::vector<std::string> ends = places("whole/instants");
    solve(run + "--set motion.distance=" + ends[1] +
          " --set motion.instants_at='2 3.8' --save half.state --out first");
    solve(run + "--set motion.distance=10 --set start.type=state --set start.state=half.state " +
          "--set motion.instants_at='7 10' --out second");
    const auto whole = by_instants("whole/instants", 2);
    const auto first = by_instants("first/instants", 2);
    EXPECT_EQ(first.at(1), whole.at(1));
    EXPECT_EQ(first.at(2), whole.at(2));
    const auto second = by_instants("second/instants", 2);
    EXPECT_EQ(second.at(1), whole.at(3)) << run;
    EXPECT_EQ(second.at(2), whole.at(4)) << run;
    const Outcome before = run_in_folder(
        run + "--set motion.distance=10 --set start.type=state --set start.state=half.state " +
        "--set motion.instants_at=2");
    EXPECT_EQ(before.status, 1);
    EXPECT_NE(
        before.error.find("motion.instants_at = 2: expected distances in rising order, from "),
        std::string::npos)
        << before.error;
  }
}

TEST_F(Instants, AreInTheCasesOfASweep) {
  solve(
      "sweep transient.info --set grid.elements=15 --set motion.instants=2 --set "
      "'sweep.load.force=-500 -900' --tables --out s");
  EXPECT_EQ(by_instants("s/cases/1/instants", 2).at(2), rows("s/cases/1/traction"));
  EXPECT_EQ(by_instants("s/cases/2/instants", 2).size(), 2U);
}

TEST_F(Instants, HaveARoleInTransientsAlone) {
  run_in_folder("init steady");
  for (const std::string key : {"motion.instants", "motion.instants_at"}) {
    const Outcome outcome = run_in_folder("steady.info --set " + key + "=2");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.error.find("microslip: key '" + key +
                                 "' has no role here: it is for problem transient"),
              0U)
        << outcome.error;
  }
}

class InstantPlots : public Instants {
 protected:
  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  }
};

TEST_F(InstantPlots, HaveAPanelForEach) {
  for (const std::string& run :
       {line, line + "--set step.scheme=direct ", ellipse, ellipse + "--set step.scheme=direct ",
        ellipse + "--set step.scheme=relaxed "}) {
    solve(run + "--set motion.instants=6");
    const std::string figure = drawn("out --figure instants", "out_instants.svg");
    EXPECT_EQ(count(figure, ">q = "), 6U) << run;
    EXPECT_NE(figure.find(fmt::format(">q = {} mm<", run.starts_with("tr") ? 20 : 40)),
              std::string::npos);
    EXPECT_NE(figure.find("rolling to the right"), std::string::npos);
    EXPECT_NE(figure.find(">slips<"), std::string::npos);
    EXPECT_EQ(figure.find(" instants<"), std::string::npos);
  }
  EXPECT_EQ(run_in_folder("plot out").output,
            "drew out.svg\ndrew out_ellipse.svg\ndrew out_instants.svg\n");
  EXPECT_EQ(run_in_folder("plot out --q 0:10").output, "drew out.svg\n");
  drawn("out --figure instants --to a.png", "a.png");
  drawn("out --figure instants --to a.pdf", "a.pdf");
}

TEST_F(InstantPlots, SelectsSomeOfManyAndMovesAll) {
  solve(line + "--set motion.instants=40");
  const std::string some = drawn("out --figure instants", "out_instants.svg");
  EXPECT_EQ(count(some, ">q = "), 12U);
  EXPECT_NE(some.find(">12 of 40 instants<"), std::string::npos);
  for (const std::string words : {"out --to run.gif", "out --figure instants --to run.gif"}) {
    const std::string gif = drawn(words, "run.gif");
    EXPECT_TRUE(gif.starts_with("GIF89a"));
    EXPECT_NE(gif.find("NETSCAPE2.0"), std::string::npos) << "it begins again";
    EXPECT_EQ(count(gif, "\x21\xf9\x04"), 40U);
  }
  solve(ellipse + "--set motion.instants=3");
  EXPECT_EQ(count(drawn("out --to run.gif", "run.gif"), "\x21\xf9\x04"), 3U);
}

TEST_F(InstantPlots, SayWhenAndWhere) {
  solve(line + with_times + "--set motion.instants=4");
  const std::string over_t = drawn("out --figure instants --over t", "out_instants.svg");
  EXPECT_EQ(count(over_t, ">t = "), 4U);
  EXPECT_NE(over_t.find(">t = 0.2 s<"), std::string::npos);
  solve(line + with_turns + "--set motion.instants=4");
  const std::string turning = drawn("out --figure instants", "out_instants.svg");
  EXPECT_EQ(count(turning, " mm, rolled "), 4U);
  EXPECT_EQ(turning.find("rolling to the"), std::string::npos);
  solve(line + "--set motion.instants=4");
  expect_refused(
      "plot out --figure instants --over t",
      "--over t: 'out' has no times: expected a run whose load.file has columns t and v");
  expect_refused("plot out --figure instants --over x", "--over 'x': expected q or t");
}

// An instant without contact is a panel that says so.
TEST_F(InstantPlots, OfNoContact) {
  std::ofstream(folder_ / "lost.tsv") << "q\tcreepage\tnormal_load\n0\t0.001\t80000\n20\t0."
                                         "001\t0\n25\t0.001\t0\n40\t0.001\t80000\n";
  solve(ellipse +
        "--set load.force= --set load.lateral_force= --set load.spin=0 --set start.type=rest --set "
        "load.file=lost.tsv --set motion.distance= --set motion.instants_at='10 22 40'");
  EXPECT_EQ(count(drawn("out --figure instants", "out_instants.svg"), ">no contact<"), 1U);
  drawn("out --to run.gif", "run.gif");
  std::ofstream(folder_ / "parted.tsv")
      << "q\tcreepage\thalf_width\n0\t0.001\t5\n10\t0.001\t0\n12\t0.001\t0\n20\t0.001\t5\n";
  solve(line +
        "--set load.force= --set start.type=rest --set load.file=parted.tsv --set motion.distance= "
        "--set motion.instants_at='5 11 20'");
  const std::string figure = drawn("out --figure instants", "out_instants.svg");
  EXPECT_EQ(count(figure, ">no contact<"), 1U);
  EXPECT_NE(figure.find(">instant 2<"), std::string::npos);
}

TEST_F(InstantPlots, WithoutThemAreRefused) {
  solve(line);
  const std::string none =
      "'out': expected the folder of a result; it has no instants.tsv, which motion.instants of a "
      "transient makes";
  expect_refused("plot out --figure instants", none);
  expect_refused("plot out --to a.gif", none);
  expect_refused("plot out --figure transient --to a.gif",
                 "--to 'a.gif': expected a name that ends in .svg, .png or .pdf, or in .gif of the "
                 "figure instants");
  solve(line + "--set motion.instants=3");
  expect_refused("plot out --figure instants --x 0:1",
                 "--x: expected a figure other than instants with it");
  expect_refused("plot out --to a.svg",
                 "--to: expected --figure with it here, one of transient, instants");
  expect_refused("plot out out --to a.gif",
                 "'out': expected one result, as figures of instants take one");
  std::ofstream(folder_ / "gnuplot") << "#!/bin/sh\n"
                                        "case \"$*\" in *'terminal gif'*) exit 1;; esac\n"
                                        "exit 3\n";
  fs::permissions(folder_ / "gnuplot", fs::perms::owner_all);
  const Outcome outcome =
      run_command("cd '" + folder_.string() +
                  "' && PATH=\"$PWD:$PATH\" " MICROSLIP_BIN "/microslip plot out --to a.gif");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(
      outcome.error,
      "microslip: cannot draw a.gif: gnuplot has no terminal gif here; .svg, .png and .pdf do "
      "without\n");
  EXPECT_FALSE(fs::exists(folder_ / "a.gif"));
}

}  // namespace microslip::instants_test
