// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/extremes.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("extremes", "what happens where nobody tunes?", scenes::study,
                            scenes::quick, experiments::read_extremes, experiments::extremes, argc,
                            argv);
}
