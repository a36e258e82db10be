// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/under_relaxation.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run(
      "under_relaxation", "does under-relaxation remove the wiggles, and at what price?",
      experiments::read_under_relaxation, experiments::under_relaxation, argc, argv);
}
