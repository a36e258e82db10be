// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <stdexcept>
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

  double summary_value(const std::string& quantity) const {
    const std::string text = text_of(out() / "summary.tsv");
    const auto at = text.find("\n" + quantity + "\t");
    if (at == std::string::npos) throw std::runtime_error("no " + quantity + " in the summary");
    return std::stod(text.substr(at + quantity.size() + 2));
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
