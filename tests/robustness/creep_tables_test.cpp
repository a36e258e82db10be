// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of creep forces by the built executable: the same bytes with shards, and after an
// interrupt; bad options are one line, and write nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "robustness/executables.hpp"

namespace microslip::creep_tables_test {

class CreepTables : public Executables {
 protected:
  fs::path file(const std::string& name) const { return out() / name; }

  Outcome table(const std::string& name, const std::string& options) const {
    std::string all;
    for (const std::string standard : {"--ratios 4", "--steps 4", "--polar 3", "--azimuths 3",
                                       "--cells 4", "--states 60", "--error-cells 5"}) {
      const std::string name_of = standard.substr(0, standard.find(' ') + 1);
      if (options.find(name_of) == std::string::npos) all += ' ' + standard;
    }
    return run_command(std::string(MICROSLIP_BIN) + "/microslip table --out '" +
                       file(name).string() + "' " + options + all);
  }
};

TEST_F(CreepTables, HaveTheSameBytesInShards) {
  ASSERT_EQ(table("one.nc", "--threads 2").status, 0);
  EXPECT_FALSE(fs::exists(file("one.nc.parts")));
  const Outcome first = table("two.nc", "--shard 2/2");
  EXPECT_EQ(first.status, 0);
  EXPECT_NE(first.output.find("7 of 14 parts are not done yet"), std::string::npos) << first.output;
  EXPECT_FALSE(fs::exists(file("two.nc")));
  ASSERT_EQ(table("two.nc", "--shard 1/2").status, 0);
  EXPECT_EQ(text_of(file("one.nc")), text_of(file("two.nc")));
  EXPECT_NE(text_of(file("one.nc")).find("error_largest_force"), std::string::npos);
}

TEST_F(CreepTables, HaveTheSameBytesByTheJobArray) {
  ASSERT_EQ(table("one.nc", "--threads 2").status, 0);
  for (const int id : {2, 0, 1}) {
    const Outcome task = run_command(
        "SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_COUNT=3 SLURM_CPUS_PER_TASK=1 "
        "MICROSLIP='" MICROSLIP_BIN "/microslip' SLURM_ARRAY_TASK_ID=" +
        std::to_string(id) + " bash '" MICROSLIP_SOURCE "/studies/table.sbatch' '" +
        file("two.nc").string() +
        "' --ratios 4 --steps 4 --polar 3 --azimuths 3 --cells 4 --states 60 --error-cells 5");
    EXPECT_EQ(task.status, 0) << task.error;
    EXPECT_EQ(fs::exists(file("two.nc")), id == 1);
  }
  EXPECT_EQ(text_of(file("one.nc")), text_of(file("two.nc")));
}

TEST_F(CreepTables, RefusePartsOfAnotherTable) {
  ASSERT_EQ(table("one.nc", "--shard 1/2").status, 0);
  const Outcome other = table("one.nc", "--shard 1/2 --poisson-ratio 0.3");
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.error.find("remove the folder to begin anew"), std::string::npos) << other.error;
}

TEST_F(CreepTables, RefuseBadOptionsInOneLine) {
  for (const char* options :
       {"--ratios 3", "--poisson-ratio 0.6", "--cells 100", "--least-ratio 20", "--states -1",
        "--error-cells 2", "--shard 3/2", "--threads 0", "--azimuths many", "--steps 5.5"}) {
    const Outcome refused = table("one.nc", options);
    EXPECT_EQ(refused.status, 1) << options;
    EXPECT_EQ(std::count(refused.error.begin(), refused.error.end(), '\n'), 1) << refused.error;
    EXPECT_FALSE(fs::exists(file("one.nc"))) << options;
  }
}

}  // namespace microslip::creep_tables_test
