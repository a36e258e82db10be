// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/leading_edge.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run(
      {.name = "leading_edge",
       .question = "is the leading edge the cause of first order?",
       .scene = scenes::study,
       .quick = scenes::quick,
       .default_out = "results/leading_edge",
       .prepare =
           [](Scene& scene) {
             return [parameters = experiments::read_leading_edge(scene)](const Progress& progress) {
               return experiments::leading_edge(parameters, progress);
             };
           }},
      argc, argv);
}
