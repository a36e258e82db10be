// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "good_scene.hpp"

namespace microslip {

namespace fs = std::filesystem;

inline const std::string good_scene = "problem steady" + good_contact + "load { creepage 0.4 }\n";

inline const std::string good_transient = "problem transient" + good_contact + R"(
start { type cattaneo }
step { ratio "1 0.5" }
motion { distance 0.33 }
load { force -1 }
)";

inline std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

struct Outcome {
  int status;
  std::string error;
  std::string output;
};

/// Tests that run the built executables, in a folder of their own.
class Executables : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("microslip_" + name + std::to_string(getpid()));
    fs::create_directories(folder_);
  }

  void TearDown() override { fs::remove_all(folder_); }

  Outcome run_command(const std::string& command) const {
    const int status = std::system((command + " 2>'" + (folder_ / "stderr").string() + "' >'" +
                                    (folder_ / "stdout").string() + "'")
                                       .c_str());
    return {WEXITSTATUS(status), text_of(folder_ / "stderr"), text_of(folder_ / "stdout")};
  }

  /// Runs `microslip` in the folder.
  Outcome run_in_folder(const std::string& words) const {
    return run_command("cd '" + folder_.string() + "' && " MICROSLIP_BIN "/microslip " + words);
  }

  /// The figure that a plot draws, as a text; its name is what the plot says.
  std::string drawn(const std::string& words, const std::string& name) const {
    fs::remove(folder_ / name);
    const Outcome outcome = run_in_folder("plot " + words);
    EXPECT_EQ(outcome.output, "drew " + name + "\n") << words << outcome.error;
    EXPECT_EQ(outcome.error, "") << words;
    return text_of(folder_ / name);
  }

  /// \param before  of the options, e.g. "sweep"
  Outcome run_program(const std::string& program, const std::string& before,
                      const std::string& scene, const std::string& options) const {
    std::ofstream(scene_file()) << scene;
    return run_command(std::string(MICROSLIP_BIN) + "/" + program + " " + before + " --scene '" +
                       scene_file().string() + "' --out '" + out().string() + "' " + options);
  }

  double summary_value(const std::string& quantity) const {
    const std::string text = text_of(out() / "summary.tsv");
    const auto at = text.find("\n" + quantity + "\t");
    if (at == std::string::npos) throw std::runtime_error("no " + quantity + " in the summary");
    return std::stod(text.substr(at + quantity.size() + 2));
  }

  fs::path scene_file() const { return folder_ / "scene.info"; }
  fs::path out() const { return folder_ / "out"; }

  fs::path folder_;
};

}  // namespace microslip
