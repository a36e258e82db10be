// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/frequency_response.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run(
      "frequency_response", "how does the force follow a creepage that oscillates a little?",
      experiments::read_frequency_response, experiments::frequency_response, argc, argv);
}
