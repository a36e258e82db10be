// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fretting.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("fretting",
                      "how much energy does an oscillating force lose when the bodies do not roll?",
                      experiments::read_fretting, experiments::fretting, argc, argv);
}
