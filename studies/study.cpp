// SPDX-License-Identifier: GPL-3.0-or-later
#include "study.hpp"

#include <sstream>
#include <string>
#include <utility>

#include "microslip/experiments/claims.hpp"
#include "microslip/scene/changed_keys.hpp"

namespace microslip::studies {

int run(const std::string& name, const std::string& question, const Scenes& scenes,
        const std::function<program::Work(Scene&)>& prepare, int argc, const char* const* argv) {
  const auto prepare_and_judge = [&](Scene& scene) -> program::Work {
    program::Work work = prepare(scene);
    std::istringstream text(scenes.study);
    Scene own = Scene::parse(text, "built-in scene");
    prepare(own);
    return [work = std::move(work), changed = changed_keys(own.parameters(), scene.parameters())](
               const Progress& progress) {
      return experiments::judged_unless_changed(work(progress), changed);
    };
  };
  return program::run({.name = name,
                       .question = question,
                       .scene = scenes.study,
                       .quick = scenes.quick,
                       .default_out = "results/" + name,
                       .prepare = prepare_and_judge},
                      argc, argv);
}

}  // namespace microslip::studies
