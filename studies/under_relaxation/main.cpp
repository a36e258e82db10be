// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/under_relaxation.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("under_relaxation",
                            "does under-relaxation remove the wiggles, and at which price?",
                            scenes::study, scenes::quick, experiments::read_under_relaxation,
                            experiments::under_relaxation, argc, argv);
}
