// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/unlike_bodies.hpp"
#include "study.hpp"

int main(int argc, char** argv) {
  using namespace microslip;
  return studies::run("unlike_bodies", "how do bodies of different material roll?",
                      experiments::read_unlike_bodies, experiments::unlike_bodies, argc, argv);
}
