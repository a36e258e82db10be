// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of results: which are drawn, over one another, of sweeps and curves, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "robustness/executables.hpp"

namespace microslip::plots_test {

class Plots : public Executables {
 protected:
  void expect_error(const std::string& words, const std::string& error) const {
    const Outcome outcome = run_in_folder(words);
    EXPECT_EQ(outcome.status, 1) << words;
    EXPECT_EQ(outcome.error, "microslip: " + error + "\n") << words;
    EXPECT_EQ(outcome.output, "") << words;
  }

  static bool has(const std::string& figure, const std::string& text) {
    return figure.find(text) != std::string::npos;
  }

  /// A steady scene in plane strain, and another one on a strip.
  void solve_steady() const {
    run_in_folder("init steady");
    const std::string plane = "--set kernel.type=plane --set kernel.width= --set kernel.length=50";
    run_in_folder("steady.info --set grid.elements=20 --out strip");
    run_in_folder("steady.info --set grid.elements=40 --out finer");
    run_in_folder("steady.info " + plane + " --out plane");
  }
};

TEST_F(Plots, OnlyResultsAreDrawn) {
  const auto rejected = [](const std::string& folder, const std::string& why) {
    return "'" + folder + "': expected the folder of a result; " + why;
  };
  expect_error("plot", rejected("out", "there is no such folder"));
  run_in_folder("init steady");
  run_in_folder("steady.info");
  fs::remove(folder_ / "out/provenance.txt");
  expect_error("plot out/", rejected("out", "it has no provenance.txt"));
  run_in_folder("sweep steady.info --shard 1/2 --set 'sweep.load.force=-1 -2' --quiet");
  expect_error("plot out/sweep",
               rejected("out/sweep", "its sweep has not ended; 'microslip merge' makes sweep.tsv"));
  EXPECT_FALSE(fs::exists(folder_ / "out.svg"));
}

TEST_F(Plots, FiguresAreWhatTheirNamesSay) {
  run_in_folder("init steady");
  run_in_folder("steady.info --set grid.elements=20");
  const std::vector<std::pair<std::string, std::string>> begins{
      {"a.svg", "<?xml"}, {"a.png", "\x89PNG\r\n"}, {"a.pdf", "%PDF-1."}};
  for (const auto& [name, begin] : begins) {
    EXPECT_EQ(run_in_folder("plot --to " + name).output, "drew " + name + "\n");
    EXPECT_TRUE(text_of(folder_ / name).starts_with(begin)) << name;
  }
  for (const std::string name : {"a.jpg", "a", "a.PNG", "svg"}) {
    expect_error("plot --to " + name,
                 "--to '" + name +
                     "': expected a name that ends in .svg, .png or .pdf, or in "
                     ".gif of the figure instants");
    EXPECT_FALSE(fs::exists(folder_ / name));
  }
}

TEST_F(Plots, ATableNamesItsResult) {
  run_in_folder("init steady");
  run_in_folder("steady.info --set grid.elements=20");
  for (const std::string result : {"out/traction.tsv", "out/", "./out", "out/../out/summary.tsv"}) {
    EXPECT_EQ(run_in_folder("plot " + result).output, "drew out.svg\n") << result;
  }
  for (const std::string result : {"traction.tsv", "."}) {
    fs::remove(folder_ / "out.svg");
    EXPECT_EQ(run_command("cd '" + (folder_ / "out").string() +
                          "' && " MICROSLIP_BIN "/microslip plot " + result)
                  .error,
              "");
    EXPECT_TRUE(fs::exists(folder_ / "out.svg")) << result;
  }
  expect_error("plot steady.info", "'" + fs::canonical(folder_).string() +
                                       "': expected the folder of a result; it has no "
                                       "provenance.txt");
}

TEST_F(Plots, StudiesAreDrawn) {
  run_command("cd '" + folder_.string() + "' && " MICROSLIP_BIN "/carter --quick --out mine");
  EXPECT_EQ(run_in_folder("plot mine").output, "drew mine_accuracy.svg\ndrew mine_traction.svg\n");
  EXPECT_EQ(run_in_folder("plot mine --figure traction --to one.svg").output, "drew one.svg\n");
  EXPECT_EQ(text_of(folder_ / "one.svg"), text_of(folder_ / "mine_traction.svg"));
  expect_error("plot mine --figure tractions",
               "--figure 'tractions': expected accuracy, traction (did you mean 'traction'?)");
  expect_error("plot mine --to one.svg",
               "--to: expected --figure with it here, one of accuracy, traction");
}

// The key has the keys in which they differ; the exact solution is there where it is one.
TEST_F(Plots, ResultsOverOneAnother) {
  solve_steady();
  const std::string alone = drawn("plane", "plane.svg");
  EXPECT_TRUE(has(alone, "Carter, exact"));
  EXPECT_FALSE(has(drawn("strip", "strip.svg"), "Carter, exact"));
  const std::string two = drawn("strip finer", "strip_and_finer.svg");
  EXPECT_TRUE(has(two, "strip: grid.elements = 20"));
  EXPECT_TRUE(has(two, "finer: grid.elements = 40"));
  const std::string three = drawn("strip finer plane", "strip_and_2_others.svg");
  EXPECT_TRUE(has(three, "Carter, exact"));
  EXPECT_FALSE(has(three, "grid.elements")) << "more than two keys differ";
  drawn("strip plane --x 4: --to near.pdf", "near.pdf");
}

TEST_F(Plots, KindsThatGoTogether) {
  solve_steady();
  run_in_folder("init transient");
  run_in_folder("transient.info --set grid.elements=20 --out rolled");
  run_in_folder("transient.info --set grid.elements=20 --set step.ratio=0.5 --out finer_steps");
  run_in_folder("response steady.info --wavelengths 5 --out answer");
  run_in_folder("response steady.info --wavelengths 5 --set load.force=-100 --out other");
  EXPECT_TRUE(has(drawn("rolled finer_steps --q 0:3", "rolled_and_finer_steps.svg"),
                  "finer_steps: step.ratio = 0.5"));
  drawn("strip rolled", "strip_and_rolled.svg");
  drawn("answer other --x :100", "answer_and_other.svg");
  expect_error("plot strip answer",
               "'answer': expected a result of the kind of 'strip', steady, not response");
  expect_error("plot answer strip",
               "'strip': expected a result of the kind of 'answer', response, not steady");
}

TEST_F(Plots, RangesThatAreNone) {
  solve_steady();
  const std::string two =
      "': expected two rising numbers as 1:2, of which one may be left out, in mm";
  for (const std::string range : {"4", "4:3", "4:4", "a:b", "1:2:3", "1 N:2 N", ""}) {
    expect_error("plot strip --x '" + range + "'", "--x '" + range + two);
  }
  const Outcome beyond = run_in_folder("plot strip --x 6:7");
  EXPECT_EQ(beyond.status, 1);
  EXPECT_TRUE(has(beyond.error, "--x '6:7': expected a range that meets -4.")) << beyond.error;
  expect_error("plot strip --q 0:1", "--q: expected a transient or a cylinder with it");
  expect_error("plot strip --over load.force",
               "--over: expected a sweep, a curve, a transient or a cylinder with it");
  run_command("cd '" + folder_.string() + "' && " MICROSLIP_BIN "/carter --quick --out mine");
  expect_error("plot mine --x 0:1", "--x: expected a result of a scene with it");
  expect_error(
      "plot strip mine",
      "'mine': expected the folder of a result; figures of studies are drawn one at a time");
  EXPECT_FALSE(fs::exists(folder_ / "strip.svg"));
}

// A measured run is drawn over its times, or over the distance rolled; --time and --q are ranges of
// these.
TEST_F(Plots, OverTimeOrDistance) {
  run_in_folder("init run");
  run_in_folder("run.info --set grid.elements=20 --set motion.distance=1400 --out ran");
  const std::string over_q = drawn("ran", "ran.svg");
  EXPECT_TRUE(has(over_q, ">distance rolled q [mm]<") && !has(over_q, "time t"));
  EXPECT_EQ(drawn("ran --over q", "ran.svg"), over_q);
  const std::string over_t = drawn("ran --over t", "ran.svg");
  EXPECT_TRUE(has(over_t, ">time t [s]<") && !has(over_t, "distance rolled"));
  EXPECT_TRUE(has(over_t, ">0.2<")) << "it ends after 0.2 s";
  EXPECT_FALSE(has(drawn("ran --over t --time '10 ms:50 ms'", "ran.svg"), ">0.2<"));
  drawn("ran ran --over t", "ran_and_ran.svg");
  run_in_folder("init cylinder");
  run_in_folder("cylinder.info --set grid.elements=20 --out rolls");
  EXPECT_TRUE(has(drawn("rolls --over t --time :0.1", "rolls.svg"), ">time t [s]<"));
  EXPECT_TRUE(has(drawn("rolls", "rolls.svg"), ">distance rolled X [mm]<"));
}

TEST_F(Plots, OfRunsThatTurnSayWhereTheyRoll) {
  run_in_folder("init transient");
  std::ofstream(folder_ / "back.tsv") << "q creepage\n0 0.001\n20 0.001\n5 0.001\n";
  std::ofstream(folder_ / "forth.tsv") << "q creepage\n0 0.001\n-20 0.001\n5 0.001\n";
  for (const std::string name : {"back", "forth"}) {
    const Outcome outcome = run_in_folder(
        "transient.info --set load.force= --set start.type=rest --set motion.distance= --set "
        "load.file=" +
        name + ".tsv --out " + name);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
  }
  const std::string back = drawn("back", "back.svg"), forth = drawn("forth", "forth.svg");
  EXPECT_TRUE(has(back, "rolling to the left at the end"));
  EXPECT_TRUE(has(back, "position q [mm]"));
  EXPECT_TRUE(has(forth, "rolling to the right"));
  EXPECT_TRUE(has(forth, "position q [mm]"));
  const std::string both = drawn("back forth", "back_and_forth.svg");
  EXPECT_FALSE(has(both, "rolling to the"));
}

TEST_F(Plots, TimesThatAreNone) {
  run_in_folder("init transient");
  run_in_folder("transient.info --set grid.elements=20 --out rolled");
  expect_error(
      "plot rolled --over t",
      "--over t: 'rolled' has no times: expected a run whose load.file has columns t and v");
  expect_error("plot rolled --over force", "--over 'force': expected q or t");
  expect_error("plot rolled --time 0:1", "--time: expected --over t with it");
  expect_error("plot rolled --value force", "--value: expected a sweep or a curve with it");
  run_in_folder("init run");
  run_in_folder("run.info --set grid.elements=20 --set motion.distance=100 --out ran");
  expect_error("plot ran --over t --q 0:1", "--q: expected --over q with it");
  expect_error(
      "plot ran rolled --over t",
      "--over t: 'rolled' has no times: expected a run whose load.file has columns t and v");
}

// Between two rows there is nothing to draw, and gnuplot would say so in its own words.
TEST_F(Plots, RangesBetweenRows) {
  run_in_folder("init transient");
  run_in_folder("transient.info --set grid.elements=20 --set 'start.force=-9 9 -9 9' --out rolled");
  for (const std::string range : {"--q 0.1:0.2", "--q 0.4:0.5", "--x 0.1:0.2"}) {
    expect_error("plot rolled " + range,
                 range.substr(0, 4) + "'" + range.substr(4) +
                     "': expected a range with two rows of the table or more");
  }
  drawn("rolled --q 0.4:1.1", "rolled.svg");
  EXPECT_FALSE(fs::exists(folder_ / "rolled_shifts.svg")) << "it has no distance";
}

// A label that is too long for the key loses what all have in common, or its middle, but stays
// unique.
TEST_F(Plots, LabelsHaveRoom) {
  run_in_folder("init steady");
  const std::string deep = "a_folder/with_a_long_name/and_another_folder/in_it/before_the_last";
  for (const std::string name : {"one", "two"}) {
    run_in_folder("steady.info --set grid.elements=20 --out " + deep + "/" + name);
  }
  const std::string two = drawn(deep + "/one " + deep + "/two --to two.svg", "two.svg");
  EXPECT_TRUE(has(two, ">…one<") && has(two, ">…two<"));
  const std::string one = "b_folder/with_a_long_name/and_another_folder/in_it/before_the_last";
  run_in_folder("steady.info --set grid.elements=20 --out " + one + "/one");
  const std::string same = drawn(deep + "/one " + one + "/one --to same.svg", "same.svg");
  EXPECT_TRUE(has(same, ">a_folder/with_a_long…") || has(same, ">2: ")) << "two labels are alike";
}

class SweepPlots : public Plots {
 protected:
  void sweep() const {
    run_in_folder("init steady");
    ASSERT_EQ(run_in_folder("sweep steady.info --quiet --tables --out s --set load.force= "
                            "--set 'sweep.kernel.width=5 10' "
                            "--set 'sweep.leading_edge=calibrated standard' "
                            "--set 'sweep.load.creepage=1e-4:log4:1e-2'")
                  .status,
              0);
  }
};

TEST_F(SweepPlots, HaveALineForEachCombination) {
  sweep();
  const std::string figure = drawn("s", "s.svg");
  EXPECT_TRUE(has(figure, "kernel.width = 10 mm, leading_edge = standard"));
  EXPECT_TRUE(has(figure, ">load.creepage<"));
  EXPECT_TRUE(has(figure, ">force [N/mm]<"));
  const std::string some = drawn("s --only kernel.width=5.0 --value dissipation", "s.svg");
  EXPECT_TRUE(has(some, ">leading_edge = standard<"));
  EXPECT_TRUE(has(some, ">dissipation [N/mm]<"));
  const std::string words = drawn("s --over leading_edge --only load.creepage=0.01", "s.svg");
  EXPECT_TRUE(has(words, ">calibrated<"));
  EXPECT_TRUE(has(words, ">kernel.width = 5 mm<"));
  EXPECT_TRUE(has(drawn("s --by leading_edge --x 0.001:", "s.svg"),
                  ">leading_edge = calibrated, kernel.width = 10 mm<"));
  EXPECT_TRUE(has(drawn("s s", "s_and_s.svg"), "s: kernel.width = 5 mm"));
  EXPECT_TRUE(has(drawn("s/cases/01 s/cases/02", "s/cases/01_and_02.svg"),
                  "s/cases/02: load.creepage = 0.000464158883361278"));
}

// One key of several that take their values together is the axis; the others make no lines.
TEST_F(SweepPlots, KeysTogetherAreOneAxis) {
  run_in_folder("init steady");
  ASSERT_EQ(run_in_folder("sweep steady.info --quiet --out s --set load.force=-100 "
                          "--set 'sweep.together.contact.half_width=3 5 7' "
                          "--set 'sweep.together.contact.peak_traction=500 300 214'")
                .status,
            0);
  const std::string figure = drawn("s", "s.svg");
  EXPECT_TRUE(has(figure, ">creepage<"));
  EXPECT_FALSE(has(figure, "peak_traction = "));
  // The last of them with numbers is the axis by default, and the other one stands beside it.
  EXPECT_TRUE(has(figure, ">contact.peak_traction [N/mm^2], with its own contact.half_width<"));
  EXPECT_TRUE(has(drawn("s --over contact.half_width", "s.svg"),
                  ">contact.half_width [mm], with its own contact.peak_traction<"));
  EXPECT_FALSE(has(drawn("s --over creepage", "s.svg"), "with its own"));
}

// Zeros alone are an axis with a word for it, and no warning of gnuplot.
TEST_F(Plots, OfNothingSayWhatIsNotThere) {
  run_in_folder("init steady");
  run_in_folder("steady.info --set load.force=0");
  EXPECT_TRUE(has(drawn("out", "out.svg"), ">no slip: all sticks<"));
  run_in_folder("steady.info --set load.force=-100");
  EXPECT_FALSE(has(drawn("out", "out.svg"), "all sticks"));
  run_in_folder("init transient");
  run_in_folder(
      "transient.info --set start.type=rest --set load.force= --set load.creepage=0 --out rest");
  const std::string rest = drawn("rest", "rest.svg");
  EXPECT_TRUE(has(rest, ">no force<") && has(rest, ">no creepage<"));
  run_in_folder(
      "transient.info --set start.type=rest --set load.force= --set load.creepage=1e-3 --out rest");
  const std::string rolling = drawn("rest", "rest.svg");
  EXPECT_FALSE(has(rolling, "no force") || has(rolling, "no creepage"));
}

// An axis of one value has a range, and long labels have the names of their keys in one heading.
TEST_F(SweepPlots, OfOneValueAndOfManyKeys) {
  run_in_folder("init steady");
  ASSERT_EQ(
      run_in_folder("sweep steady.info --quiet --out s --set 'sweep.kernel.width=5 10'").status, 0);
  drawn("s --value force", "s.svg");
  drawn("s --value force --only kernel.width=5", "s.svg");
  ASSERT_EQ(run_in_folder("sweep steady.info --quiet --out many --set 'sweep.kernel.width=5 10' "
                          "--set 'sweep.contact.half_width=4.5 5' "
                          "--set 'sweep.material.poisson_ratio=0.25 0.3' "
                          "--set 'sweep.load.force=-100:-100:-900'")
                .status,
            0);
  const std::string figure = drawn("many", "many.svg");
  EXPECT_TRUE(has(figure, ">kernel.width, contact.half_width, material.poisson_ratio<"));
  EXPECT_TRUE(has(figure, ">10 mm, 4.5 mm, 0.25<"));
}

TEST_F(SweepPlots, NameWhatIsNotThere) {
  sweep();
  const Outcome column = run_in_folder("plot s --value forces");
  EXPECT_TRUE(has(column.error, "--value 'forces': expected one of case, kernel.width, "))
      << column.error;
  EXPECT_TRUE(has(column.error, "(did you mean 'force'?)")) << column.error;
  expect_error("plot s --value method",
               "--value 'method': expected a column with numbers, of which there are none");
  expect_error("plot s --only kernel.width", "--only 'kernel.width': expected key=value");
  expect_error("plot s --only kernel.width=7",
               "--only 'kernel.width=7': expected a value that is there: 10, 5");
  expect_error("plot s --by load.creepage",
               "--by 'load.creepage': expected a swept key that has several values, of "
               "kernel.width, leading_edge");
  run_in_folder(
      "sweep steady.info --quiet --out many --set load.force= "
      "--set 'sweep.kernel.width=5:1:30' --set 'sweep.load.creepage=1e-6:1e-6:3e-5'");
  expect_error("plot many",
               "--only: expected fewer than 26 lines, at most 24; one value of a key is shown by "
               "--only kernel.width=5");
  EXPECT_FALSE(fs::exists(folder_ / "many.svg"));
}

}  // namespace microslip::plots_test
