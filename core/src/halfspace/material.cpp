// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/material.hpp"

#include "microslip/support/require.hpp"

namespace microslip {

void validate(const Material& material) {
  require_positive("material.shear_modulus", material.shear_modulus);
  const double nu = material.poisson_ratio;
  require(nu >= 0 && nu <= 0.5, "material.poisson_ratio", nu, "a number in [0, 0.5]");
}

double compliance(const Material& material) {
  return 2 * (1 - material.poisson_ratio) / material.shear_modulus;
}

}  // namespace microslip
