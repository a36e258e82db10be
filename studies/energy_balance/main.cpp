// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/energy_balance.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("energy_balance", "how does the energy balance of a rolling cylinder close?",
                      experiments::read_energy_balance, experiments::energy_balance, argc, argv);
}
