// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/basis_convergence.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("basis_convergence", "do higher-order functions converge faster?",
                      experiments::read_basis_convergence, experiments::basis_convergence, argc,
                      argv);
}
