// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fourier_inverse.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("fourier_inverse", "why does the inverse of A - A' oscillate?",
                      experiments::read_fourier_inverse, experiments::fourier_inverse, argc, argv);
}
