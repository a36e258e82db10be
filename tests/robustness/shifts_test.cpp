// SPDX-License-Identifier: GPL-3.0-or-later
// Shifts without rolling in a scene, as the program writes them.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "microslip/reference/fretting_cycle.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/format.hpp"
#include "robustness/executables.hpp"

namespace microslip::shifts_test {

const Material material{1, 0.28};
const HertzBound hertz(1, 1);
constexpr double length = 20;

class Shifts : public Executables {
 protected:
  /// Rolls under another force than that of the last shift. The loss in the step to it is warned
  /// of, and this warning is taken out.
  /// \param elements  N
  /// \param start     keys below `start`
  Outcome run(int elements, const std::string& start, const std::string& options = "") const {
    Outcome outcome = run_program(
        "microslip", "",
        "problem transient\n" + good_contact + "start { type cattaneo\n" + start +
            "\n}\nstep { ratio 1 }\nmotion { distance 0.5 }\nload { force -0.5 }\n",
        "--set kernel.width= --set kernel.type=plane --set kernel.length=" + format_short(length) +
            " --set grid.elements=" + std::to_string(elements) + " " + options);
    const bool is_sudden =
        outcome.error.find("because the force changes by more") != std::string::npos;
    if (is_sudden) outcome.error.erase(0, outcome.error.find('\n') + 1);
    return outcome;
  }

  /// Returns a table of the last run.
  WrittenTable table(const std::string& name) const {
    return read_table(name, text_of(out() / (name + ".tsv")));
  }

  std::vector<double> column(const std::string& of, const std::string& name) const {
    const WrittenTable written = table(of);
    std::vector<double> values;
    for (std::size_t i = 0; i < written.table.rows(); ++i) {
      values.push_back(std::stod(std::get<std::string>(written.table.at(i, name))));
    }
    return values;
  }

  std::string drawn() const { return run_in_folder("plot").output; }
};

std::string list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += ' ' + format_short(value);
  return text;
}

// From rest to F*, back to -F* and forth, by steps: Mindlin's loop and what it loses.
TEST_F(Shifts, GoAlongMindlinsLoop) {
  for (const double tau : {0.3, 0.6, 0.9}) {
    const double most = tau * hertz.total();
    std::vector<double> forces{most};
    for (const double part : {0.5, 0.0, -0.5, -1.0, -0.5, 0.0, 0.5, 1.0}) {
      forces.push_back(part * most);
    }
    const FrettingCycle cycle(material, hertz, most);
    const double scale = std::abs(cycle.shift(most, length));
    SCOPED_TRACE(tau);
    ASSERT_EQ(run(400, "force \"" + list(forces) + "\"").error, "");
    const std::vector<double> force = column("shifts", "force");
    const std::vector<double> shift = column("shifts", "total_shift");
    const std::vector<double> lost = column("shifts", "dissipation");
    ASSERT_EQ(force.size(), 1 + forces.size());
    EXPECT_EQ(force[0], 0);
    EXPECT_EQ(shift[0], 0);
    double sum = 0;
    for (std::size_t i = 1; i < force.size(); ++i) {
      EXPECT_NEAR(force[i], forces[i - 1], 1e-12 * most);
      const bool is_forth = i > 5;  // the way back, mirrored
      const double exact =
          (is_forth ? -1 : 1) * cycle.shift((is_forth ? -1 : 1) * forces[i - 1], length);
      EXPECT_NEAR(shift[i], exact, 1e-5 * scale) << i;
      if (i > 1) sum += lost[i];
    }
    EXPECT_NEAR(sum, cycle.dissipation(), 1e-3 * cycle.dissipation());
  }
}

// Rows are differences: what the force does is lost or stored.
TEST_F(Shifts, BalanceEnergy) {
  for (const std::string scheme : {"remembered", "direct", "relaxed_traction"}) {
    for (const std::string start : {"force \"1 -1.2 0.3 0 -0.7\"", "shift \"1 um -2 um 3 um\""}) {
      // Ten whole elements.
      const std::string distance = " --set motion.distance=0.48780487804878048";
      ASSERT_EQ(run(41, start, "--set step.scheme=" + scheme + distance).error, "");
      const std::vector<double> work = column("shifts", "work");
      const std::vector<double> lost = column("shifts", "dissipation");
      const std::vector<double> stored = column("shifts", "elastic_energy");
      for (std::size_t i = 1; i < work.size(); ++i) {
        EXPECT_NEAR(work[i] - lost[i], stored[i] - stored[i - 1], 1e-12) << scheme << start << i;
      }
    }
  }
}

// Nothing is done by a force then: what slips loses energy that was stored. Backward slip once was
// held against the power of the creepage, which is none, and ended as no solution.
TEST_F(Shifts, MayBeFollowedByFreeRolling) {
  for (const std::string creepage : {"0", "1e-9", "-1e-6"}) {
    for (const std::string scheme : {"remembered", "direct"}) {
      const Outcome outcome =
          run(20, "force -0.2",
              "--set step.scheme=" + scheme + " --set step.ratio=0.3 --set load.force= " +
                  "--set motion.distance=6 --set load.creepage=" + creepage);
      EXPECT_EQ(outcome.status, 0) << outcome.error;
    }
  }
}

// A shift to the force that is there changes nothing, so that two of them are the ordinary start.
TEST_F(Shifts, ToOneForceAreTheOrdinaryStart) {
  ASSERT_EQ(run(41, "force -1").error, "");
  EXPECT_FALSE(fs::exists(out() / "shifts.tsv"));
  const auto rows = [&] {
    const std::string text = text_of(out() / "history.tsv");
    return text.substr(text.find("\nq\t"));
  };
  const std::string once = rows();
  ASSERT_EQ(run(41, "force \"-1 -1\"").error, "");
  EXPECT_EQ(rows(), once);
  EXPECT_EQ(column("shifts", "shift")[2], 0);
  const double shift = column("shifts", "shift")[1];
  ASSERT_EQ(run(41, "shift " + format_short(shift)).error, "");
  EXPECT_NEAR(column("history", "force")[0], -1, 1e-6);
  EXPECT_EQ(column("shifts", "total_shift"), (std::vector<double>{0, shift}));
}

// Other units, and the mirror image.
TEST_F(Shifts, DependOnUnitsAndSignsAsTheyShould) {
  ASSERT_EQ(run(41, "force \"1 -0.5 0.25 N/mm\"").error, "");
  const std::string plain = text_of(out() / "shifts.tsv");
  const std::vector<double> shift = column("shifts", "shift");
  for (const char* same : {"1 -0.5 0.25", "1e3 -500 250 N/m", "1e-3 MN/m -0.5 N/mm 0.25 kN/m"}) {
    ASSERT_EQ(run(41, std::string("force \"") + same + "\"").error, "");
    EXPECT_EQ(text_of(out() / "shifts.tsv"), plain);
  }
  ASSERT_EQ(run(41, "force \"-1 0.5 -0.25\"", "--set load.force=0.5").error, "");
  const std::vector<double> mirrored = column("shifts", "shift");
  ASSERT_EQ(mirrored.size(), shift.size());
  for (std::size_t i = 0; i < shift.size(); ++i) EXPECT_DOUBLE_EQ(mirrored[i], -shift[i]);
}

TEST_F(Shifts, AreSummedUpInTheSummaryOfASweep) {
  ASSERT_EQ(run_program("microslip", "sweep", good_transient,
                        "--quiet --set 'sweep.start.force=1 -1 | 0.5 -0.5 kN/m'")
                .error,
            "");
  EXPECT_NE(text_of(out() / "sweep.tsv").find("\n1\t1 -1\t"), std::string::npos);
  EXPECT_NE(text_of(out() / "sweep.tsv").find("\n2\t0.5 -0.5\t"), std::string::npos);
  const std::vector<double> lost = column("sweep", "shift_dissipated_energy");
  EXPECT_GT(lost[0], 2 * lost[1]);
  EXPECT_GT(lost[1], 0);
  EXPECT_EQ(column("sweep", "shifts"), (std::vector<double>{2, 2}));
}

// Two make no loop.
TEST_F(Shifts, AreDrawnFromThreeOn) {
  ASSERT_EQ(run(41, "force \"1 -1\"").error, "");
  EXPECT_EQ(drawn(), "drew out.svg\n");
  ASSERT_EQ(run(41, "force \"1 -1 1\"").error, "");
  EXPECT_EQ(drawn(), "drew out.svg\ndrew out_shifts.svg\n");
  EXPECT_TRUE(text_of(folder_ / "out_shifts.svg").ends_with("</svg>\n\n"));
}

TEST_F(Shifts, AreExplained) {
  std::ofstream(scene_file()) << good_transient;
  const auto explained = [&](const std::string& start) {
    return run_command(MICROSLIP_BIN "/microslip explain '" + scene_file().string() +
                       "' --set 'start." + start + "'")
        .output;
  };
  EXPECT_NE(explained("force=1 -0.5 N/mm").find("start.force             1 -0.5 N/mm   force"),
            std::string::npos);
  EXPECT_NE(explained("force=1 -0.5 1")
                .find("  3 shifts without rolling before it, to at most "
                      "0.63662 of full sliding\n"),
            std::string::npos);
  EXPECT_NE(explained("shift=-0.5").find("  1 shift without rolling before it, by at most 0.5 mm"),
            std::string::npos);
  EXPECT_EQ(explained("force=1").find("without rolling before it"), std::string::npos);
}

}  // namespace microslip::shifts_test
