// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/varying_load.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("varying_load", "how does the force follow a normal load that oscillates?",
                      experiments::read_varying_load, experiments::varying_load, argc, argv);
}
