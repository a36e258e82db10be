// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/energy_balance.hpp"
#include "microslip/program/run.hpp"
#include "scenes.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return program::run_study("energy_balance",
                            "how does the balance of energy of a rolling cylinder close?",
                            scenes::study, scenes::quick, experiments::read_energy_balance,
                            experiments::energy_balance, argc, argv);
}
