// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/cylinder_scene.hpp"
#include "microslip/experiments/steady_scene.hpp"
#include "microslip/experiments/transient_scene.hpp"
#include "microslip/program/run.hpp"
#include "microslip/scene/model.hpp"

namespace {

using namespace microslip;

program::Work prepare(Scene& scene) {
  const std::string problem = scene.word("problem", {"steady", "transient", "cylinder"});
  if (problem == "steady") {
    return [steady = read_steady(scene)](const Progress&) {
      return experiments::steady_scene(steady);
    };
  }
  if (problem == "cylinder") {
    return [cylinder = read_cylinder(scene)](const Progress& progress) {
      return experiments::cylinder_scene(cylinder, progress);
    };
  }
  return [transient = read_transient(scene)](const Progress& progress) {
    return experiments::transient_scene(transient, progress);
  };
}

}  // namespace

int main(int argc, char** argv) {
  return program::run({.name = "microslip",
                       .question = "solves one scene of your own",
                       .scene = "",
                       .quick = "",
                       .default_out = "out",
                       .prepare = prepare},
                      argc, argv);
}
