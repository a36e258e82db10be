// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "microslip/program/run.hpp"

namespace microslip::studies {

/// The texts of study.info and quick.info.
struct Scenes {
  const char* study;
  const char* quick;
};

/// Runs a study with its two scenes; `prepare` is that of its program::Program. The claims of the
/// study are judged if all parameters are equal to study.info, whatever the way in which they were
/// given. A quick run has others.
int run(const std::string& name, const std::string& question, const Scenes& scenes,
        const std::function<program::Work(Scene&)>& prepare, int argc, const char* const* argv);

}  // namespace microslip::studies
