// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "microslip/rolling/transient.hpp"

int main() {
  microslip::TransientRolling rolling(
      {.contact = {microslip::StripKernel({.shear_modulus = 82000, .poisson_ratio = 0.28}, 10),
                   microslip::HertzBound(5, 300)},
       .grid = microslip::Grid({.half_width = 5, .elements = 100}),
       .basis = microslip::constant_basis(),
       .scheme = microslip::Remembered{}});
  rolling.step(0.37, microslip::PrescribedCreepage{0.002});
  std::printf("%.17g\n", rolling.state().force);
}
