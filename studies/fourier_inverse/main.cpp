// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fourier_inverse.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run({.name = "fourier_inverse",
                       .question = "why does the inverse of A - A' oscillate?",
                       .scene = scenes::study,
                       .quick = scenes::quick,
                       .default_out = "results/fourier_inverse",
                       .prepare =
                           [](Scene& scene) {
                             return [parameters = experiments::read_fourier_inverse(scene)](
                                        const Progress& progress) {
                               return experiments::fourier_inverse(parameters, progress);
                             };
                           }},
                      argc, argv);
}
