// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run({.name = "bench",
                       .question = "what does it cost, and how does that grow?",
                       .scene = scenes::study,
                       .quick = scenes::quick,
                       .default_out = "results/bench",
                       .prepare = program::prepare_by(bench::read_bench, bench::bench)},
                      argc, argv);
}
