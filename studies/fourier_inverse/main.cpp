// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/fourier_inverse.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("fourier_inverse", "why does the inverse of A - A' oscillate?",
                            scenes::study, scenes::quick, experiments::read_fourier_inverse,
                            experiments::fourier_inverse, argc, argv);
}
