// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/smoothing.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("smoothing", "what becomes of a traction peak that travels?",
                            scenes::study, scenes::quick, experiments::read_smoothing,
                            experiments::smoothing, argc, argv);
}
