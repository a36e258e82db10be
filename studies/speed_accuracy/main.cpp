// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/speed_accuracy.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("speed_accuracy", "what does an accuracy cost, by which scheme?",
                            scenes::study, scenes::quick, experiments::read_speed_accuracy,
                            experiments::speed_accuracy, argc, argv);
}
