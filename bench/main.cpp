// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("bench", "what does it cost, and how does that grow?", scenes::study,
                            scenes::quick, bench::read_bench, bench::bench, argc, argv);
}
