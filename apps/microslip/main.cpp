// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/steady_scene.hpp"
#include "microslip/program/run.hpp"
#include "microslip/scene/model.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run({.name = "microslip",
                       .question = "solves one scene of your own",
                       .scene = "",
                       .quick = "",
                       .default_out = "out",
                       .prepare =
                           [](Scene& scene) {
                             scene.word("problem", {"steady"});
                             return [problem = read_steady(scene)](const Progress&) {
                               return experiments::steady_scene(problem);
                             };
                           }},
                      argc, argv);
}
