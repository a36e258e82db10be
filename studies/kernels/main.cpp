// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/kernels.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("kernels", "which results depend on the kernel: half-space, layer or brush?",
                      experiments::read_kernels, experiments::kernels, argc, argv);
}
