// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "robustness/executables.hpp"

namespace microslip {

/// Scenes that are solved or refused with one line, and no file then.
class BadScenes : public Executables {
 protected:
  Outcome run(const std::string& scene, const std::string& options,
              const std::string& program = "microslip") const {
    return run_program(program, "", scene, options);
  }

  void expect_rejected(const std::string& scene, const std::string& options,
                       const std::string& named) const {
    const Outcome outcome = run(scene, options);
    EXPECT_EQ(outcome.status, 1) << options;
    EXPECT_EQ(outcome.error.rfind("microslip: ", 0), 0U) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(named), std::string::npos) << outcome.error;
    EXPECT_FALSE(fs::exists(out())) << options;
  }
};

}  // namespace microslip
