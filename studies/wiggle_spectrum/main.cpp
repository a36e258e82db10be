// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/wiggle_spectrum.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study(
      "wiggle_spectrum", "what makes the solution wiggle when the step is small?", scenes::study,
      scenes::quick, experiments::read_wiggle_spectrum, experiments::wiggle_spectrum, argc, argv);
}
