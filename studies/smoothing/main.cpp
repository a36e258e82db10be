// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/smoothing.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("smoothing",
                      "how much does each step ratio smooth a travelling traction peak?",
                      experiments::read_smoothing, experiments::smoothing, argc, argv);
}
