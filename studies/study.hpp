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

/// Reads all parameters of a study from a scene, and returns what measures with them.
using Prepare = std::function<program::Work(Scene&)>;

/// Runs a study with its two scenes. Its claims are judged if all parameters are equal to
/// study.info, whatever the way in which they were given; a quick run has others.
int run(const std::string& name, const std::string& question, const Scenes& scenes,
        const Prepare& prepare, int argc, const char* const* argv);

/// \param read     takes the study's parameters from a scene
/// \param measure  makes its tables with them
template <class Read, class Measure>
Prepare prepare_by(Read read, Measure measure) {
  return [=](Scene& scene) -> program::Work {
    return [parameters = read(scene), measure](const Progress& progress) {
      return measure(parameters, progress);
    };
  };
}

}  // namespace microslip::studies
