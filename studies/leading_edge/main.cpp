// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/leading_edge.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("leading_edge", "is the leading edge the cause of first order?",
                      experiments::read_leading_edge, experiments::leading_edge, argc, argv);
}
