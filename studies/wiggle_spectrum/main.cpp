// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/wiggle_spectrum.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("wiggle_spectrum", "why does the solution wiggle when the step is small?",
                      experiments::read_wiggle_spectrum, experiments::wiggle_spectrum, argc, argv);
}
