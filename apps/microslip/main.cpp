// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>
#include <string>

#include "microslip/experiments/cylinder_scene.hpp"
#include "microslip/experiments/steady_scene.hpp"
#include "microslip/experiments/transient_scene.hpp"
#include "microslip/program/memory.hpp"
#include "microslip/program/run.hpp"
#include "microslip/program/sweep.hpp"
#include "microslip/scene/memory.hpp"
#include "microslip/scene/model.hpp"

namespace {

using namespace microslip;

/// In a case of a sweep, the section has been taken out.
void reject_sweep(const Scene& scene) {
  for (const std::string& key : scene.keys()) {
    if (!key.starts_with("sweep.")) continue;
    throw std::invalid_argument("key '" + key + "': expected a scene without a sweep; for many " +
                                "see 'microslip sweep --help'");
  }
}

const Grid& grid_of(const SteadyProblem& problem) { return problem.grid; }
const Grid& grid_of(const TransientScene& scene) { return scene.problem.grid; }
const Grid& grid_of(const CylinderScene& scene) { return scene.contact.grid; }

/// What was read, if there is memory to solve it.
template <class Read>
Read affordable(Read read) {
  program::require_memory("grid.elements", grid_of(read).size(), memory_needed(read));
  return read;
}

program::Work prepare(Scene& scene) {
  reject_sweep(scene);
  const std::string problem = scene.word("problem", {"steady", "transient", "cylinder"});
  if (problem != "steady" && scene.has("target_error")) {
    throw std::invalid_argument("target_error: expected in problem steady only");
  }
  if (scene.has("target_error")) {
    return [target = read_steady_target(scene)](const Progress&) {
      return experiments::steady_scene(target);
    };
  }
  if (problem == "steady") {
    return [steady = affordable(read_steady(scene))](const Progress&) {
      return experiments::steady_scene(steady);
    };
  }
  if (problem == "cylinder") {
    return [cylinder = affordable(read_cylinder(scene))](const Progress& progress) {
      return experiments::cylinder_scene(cylinder, progress);
    };
  }
  return [transient = affordable(read_transient(scene))](const Progress& progress) {
    return experiments::transient_scene(transient, progress);
  };
}

}  // namespace

int main(int argc, char** argv) {
  const program::Program solver{
      .name = "microslip",
      .question =
          "solves one scene of your own; 'microslip sweep' solves many, and 'microslip "
          "merge' puts\ntheir results together: see 'microslip sweep --help'",
      .scene = "",
      .quick = "",
      .default_out = "out",
      .key_options = {{"target-error", "target_error",
                       "largest relative error of the force or creepage of steady rolling; picks "
                       "method and grid"}},
      .prepare = prepare};
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "sweep") return program::sweep(solver, argc, argv);
  if (command == "merge") return program::merge(solver, argc, argv);
  return program::run(solver, argc, argv);
}
