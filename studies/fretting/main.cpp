// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fretting.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("fretting",
                      "shifts without rolling: what does a force to and fro lose, and what comes "
                      "before and after rolling?",
                      experiments::read_fretting, experiments::fretting, argc, argv);
}
