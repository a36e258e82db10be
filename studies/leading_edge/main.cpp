// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/leading_edge.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("leading_edge", "is the leading edge the cause of first order?",
                            scenes::study, scenes::quick, experiments::read_leading_edge,
                            experiments::leading_edge, argc, argv);
}
