// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/extremes.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("extremes", "what happens where nobody tunes?", experiments::read_extremes,
                      experiments::extremes, argc, argv);
}
