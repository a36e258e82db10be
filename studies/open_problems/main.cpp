// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/open_problems.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("open_problems", "which schemes give second order, any step and ten digits?",
                      experiments::read_open_problems, experiments::open_problems, argc, argv);
}
