// SPDX-License-Identifier: GPL-3.0-or-later
// Writers meet what is no regular file: pipes, devices and links, made in the folder of the test.
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <fstream>
#include <string>

#include "robustness/executables.hpp"

namespace microslip::devices_test {

class Devices : public Executables {
 protected:
  void SetUp() override {
    Executables::SetUp();
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    has_device_ = mknod((folder_ / "device").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0;
    std::ofstream(folder_ / "old") << "old";
    fs::create_symlink("old", folder_ / "link");
  }

  Outcome run_here(const std::string& options) const {
    return run_command("cd '" + folder_.string() + "' && timeout 20 " MICROSLIP_BIN "/microslip " +
                       options);
  }

  bool has_device_ = false;
};

TEST_F(Devices, AreNotReplacedBySavedStates) {
  std::ofstream(scene_file()) << good_transient;
  const Outcome pipe = run_here("scene.info --out out --save pipe");
  EXPECT_EQ(pipe.status, 1);
  EXPECT_NE(pipe.error.find("/pipe: it is a pipe, expected a regular file\n"), std::string::npos)
      << pipe.error;
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  EXPECT_FALSE(fs::exists(out()));
  if (has_device_) {
    const Outcome device = run_here("scene.info --out out --save device");
    EXPECT_EQ(device.status, 1);
    EXPECT_TRUE(fs::is_character_file(folder_ / "device"));
  }
  EXPECT_EQ(run_here("scene.info --out out --save link").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_NE(text_of(folder_ / "old"), "old");
}

TEST_F(Devices, AreNotReplacedByTablesAndFigures) {
  std::ofstream(scene_file()) << good_scene;
  EXPECT_EQ(run_here("scene.info --out out").status, 0);
  fs::remove(out() / "summary.tsv");
  ASSERT_EQ(mkfifo((out() / "summary.tsv").c_str(), 0600), 0);
  EXPECT_EQ(run_here("scene.info --out out").status, 1);
  EXPECT_TRUE(fs::is_fifo(out() / "summary.tsv"));
  fs::rename(folder_ / "pipe", folder_ / "figure.svg");
  EXPECT_EQ(run_here("plot out --to figure.svg").status, 1);
  EXPECT_TRUE(fs::is_fifo(folder_ / "figure.svg"));
}

}  // namespace microslip::devices_test
