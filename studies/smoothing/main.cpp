// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/smoothing.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("smoothing", "what becomes of a traction peak that travels?",
                      experiments::read_smoothing, experiments::smoothing, argc, argv);
}
