// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/basis_convergence.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run({.name = "basis_convergence",
                       .question = "do higher-order functions converge faster?",
                       .scene = scenes::study,
                       .quick = scenes::quick,
                       .default_out = "results/basis_convergence",
                       .prepare =
                           [](Scene& scene) {
                             return [parameters = experiments::read_basis_convergence(scene)](
                                        const Progress& progress) {
                               return experiments::basis_convergence(parameters, progress);
                             };
                           }},
                      argc, argv);
}
