// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/carter.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run(
      {.name = "carter",
       .question = "what does the step ratio do to the Carter-Fromm problem?",
       .scene = scenes::study,
       .quick = scenes::quick,
       .default_out = "results/carter",
       .prepare =
           [](Scene& scene) {
             return [parameters = experiments::read_carter(scene)](const Progress& progress) {
               return experiments::carter(parameters, progress);
             };
           }},
      argc, argv);
}
