// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/wiggle_spectrum.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run({.name = "wiggle_spectrum",
                       .question = "what makes the solution wiggle when the step is small?",
                       .scene = scenes::study,
                       .quick = scenes::quick,
                       .default_out = "results/wiggle_spectrum",
                       .prepare =
                           [](Scene& scene) {
                             return [parameters = experiments::read_wiggle_spectrum(scene)](
                                        const Progress& progress) {
                               return experiments::wiggle_spectrum(parameters, progress);
                             };
                           }},
                      argc, argv);
}
