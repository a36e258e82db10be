// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "microslip/experiments/claims.hpp"
#include "microslip/program/run.hpp"
#include "microslip/scene/changed_keys.hpp"

namespace microslip::studies {

/// The texts of study.info and quick.info.
struct Scenes {
  const char* study;
  const char* quick;
};

/// Runs a study with its two scenes. Its claims are judged if all parameters are equal to
/// study.info, whatever the way in which they were given; a quick run has others.
template <class Read, class Measure>
int run(const std::string& name, const std::string& question, const Scenes& scenes, Read read,
        Measure measure, int argc, const char* const* argv) {
  const auto read_and_compare = [&](Scene& scene) {
    auto parameters = read(scene);
    std::istringstream text(scenes.study);
    Scene own = Scene::parse(text, "built-in scene");
    read(own);
    return std::pair(std::move(parameters), changed_keys(own.parameters(), scene.parameters()));
  };
  const auto measure_and_judge = [measure](const auto& from, const Progress& progress) {
    return experiments::judged_unless_changed(measure(from.first, progress), from.second);
  };
  return program::run_study(name, question, scenes.study, scenes.quick, read_and_compare,
                            measure_and_judge, argc, argv);
}

}  // namespace microslip::studies
