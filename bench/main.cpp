// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  const auto prepare = [](Scene& scene) -> program::Work {
    return [parameters = bench::read_bench(scene)](const Progress& progress) {
      return bench::bench(parameters, progress);
    };
  };
  return program::run({.name = "bench",
                       .question = "what does it cost, and how does that grow?",
                       .scene = scenes::study,
                       .quick = scenes::quick,
                       .default_out = "results/bench",
                       .prepare = prepare},
                      argc, argv);
}
