// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/extremes.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("extremes", "where does each scheme fail?", experiments::read_extremes,
                      experiments::extremes, argc, argv);
}
