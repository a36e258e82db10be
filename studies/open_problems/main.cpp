// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/open_problems.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("open_problems",
                            "second order, any step, ten digits: what solves what was left open?",
                            scenes::study, scenes::quick, experiments::read_open_problems,
                            experiments::open_problems, argc, argv);
}
