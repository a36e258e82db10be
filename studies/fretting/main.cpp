// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fretting.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("fretting",
                      "what does a force to and fro lose without rolling, and between two ways of "
                      "rolling?",
                      experiments::read_fretting, experiments::fretting, argc, argv);
}
