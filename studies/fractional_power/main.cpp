// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fractional_power.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run(
      "fractional_power", "do fractional powers keep travelling peaks sharp, and at what cost?",
      experiments::read_fractional_power, experiments::fractional_power, argc, argv);
}
