// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/world_fixed.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("world_fixed", "what is odd about a grid that is fixed to the world?",
                            scenes::study, scenes::quick, experiments::read_world_fixed,
                            experiments::world_fixed, argc, argv);
}
