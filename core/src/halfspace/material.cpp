// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/material.hpp"

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

void validate(const Material& material, double least_poisson_ratio) {
  require_positive("shear_modulus", material.shear_modulus);
  const double nu = material.poisson_ratio;
  require(nu >= least_poisson_ratio && nu <= 0.5, "poisson_ratio", nu,
          [&] { return "a number in [" + format_short(least_poisson_ratio) + ", 0.5]"; });
}

}  // namespace

void validate(const Material& material) { validate(material, 0); }

void validate_also_lateral(const Material& material) { validate(material, -1); }

Material lateral(const Material& material) {
  const auto [g, nu] = material;
  return {.shear_modulus = g / (1 - nu), .poisson_ratio = -nu / (1 - nu)};
}

Bodies combined(const Material& first, const Material& second) {
  validate(first);
  validate(second);
  const auto [g1, nu1] = first;
  const auto [g2, nu2] = second;
  const double shear = 2 / (1 / g1 + 1 / g2);
  const double poisson = shear * (nu1 / g1 + nu2 / g2) / 2;
  const double beta =
      ((1 - 2 * nu2) / g2 - (1 - 2 * nu1) / g1) / (2 * ((1 - nu1) / g1 + (1 - nu2) / g2));
  return {{.shear_modulus = shear, .poisson_ratio = poisson}, beta};
}

double pressure_strain(const Bodies& bodies, double friction) {
  return compliance(bodies.combined) * bodies.dundurs_beta / friction;
}

double compliance(const Material& material) {
  return 2 * (1 - material.poisson_ratio) / material.shear_modulus;
}

}  // namespace microslip
