// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/carter.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("carter",
                      "how does the step ratio change the solution of the Carter-Fromm problem?",
                      experiments::read_carter, experiments::carter, argc, argv);
}
