// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fractional_power.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("fractional_power",
                            "do fractional powers keep travelling peaks sharp, and at which cost?",
                            scenes::study, scenes::quick, experiments::read_fractional_power,
                            experiments::fractional_power, argc, argv);
}
