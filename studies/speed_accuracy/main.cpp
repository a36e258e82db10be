// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/speed_accuracy.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("speed_accuracy", "what does a given accuracy cost with each scheme?",
                      experiments::read_speed_accuracy, experiments::speed_accuracy, argc, argv);
}
