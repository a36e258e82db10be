// SPDX-License-Identifier: GPL-3.0-or-later
// Which runs of a study are judged: those with its own parameters, however they were given.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"
#include "robustness/executables.hpp"

namespace microslip::verdicts_test {

class Verdicts : public Executables {
 protected:
  /// The text of claims.tsv.
  std::string claims(const std::string& options) const {
    const std::string command = MICROSLIP_BIN "/carter --quiet --out '" + out().string() + "' ";
    const Outcome outcome = run_command(command + options);
    EXPECT_EQ(outcome.error, "") << options;
    return text_of(out() / "claims.tsv");
  }

  void expect_not_judged(const std::string& options, const std::string& changed) const {
    const std::string text = claims(options);
    const Table table = read_table("claims", text).table;
    ASSERT_EQ(table.rows(), 2U);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      EXPECT_EQ(std::get<std::string>(table.at(i, "verdict")), "not_judged") << options;
      EXPECT_NE(std::get<std::string>(table.at(i, "rule")), "") << options;
    }
    const std::string said = text.substr(0, text.find('\n'));
    EXPECT_TRUE(
        said.ends_with("; not judged: this run has other parameters than the study: " + changed))
        << said;
  }
};

TEST_F(Verdicts, BelongToTheStudysOwnParameters) {
  const std::string own = claims("");
  EXPECT_NE(own.find("\treproduced\t"), std::string::npos);
  EXPECT_EQ(own.find("\tnot_judged\t"), std::string::npos);
  EXPECT_EQ(claims("--set load.creepage=0.5760"), own);
  EXPECT_EQ(claims("--set solver.type=auto"), own);  // the default
  const std::string scene = run_command(MICROSLIP_BIN "/carter --print-scene").output;
  std::ofstream(scene_file()) << scene;
  EXPECT_EQ(claims("--scene '" + scene_file().string() + "'"), own);
}

TEST_F(Verdicts, AreNotGivenForOthers) {
  expect_not_judged("--set load.creepage=0.57", "load.creepage");
  expect_not_judged("--set grid.elements=20 --set kernel.length=100",
                    "kernel.length, grid.elements");
  expect_not_judged("--set load.creepage= --set load.force=-1", "load.creepage, load.force");
  expect_not_judged("--quick", "grid.elements");
}

}  // namespace microslip::verdicts_test
