// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/world_fixed.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("world_fixed",
                      "why does the creepage jump on a grid that is fixed to the world?",
                      experiments::read_world_fixed, experiments::world_fixed, argc, argv);
}
