// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/carter.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("carter", "what does the step ratio do to the Carter-Fromm problem?",
                            scenes::study, scenes::quick, experiments::read_carter,
                            experiments::carter, argc, argv);
}
