// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/basis_convergence.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("basis_convergence", "do higher-order functions converge faster?",
                            scenes::study, scenes::quick, experiments::read_basis_convergence,
                            experiments::basis_convergence, argc, argv);
}
