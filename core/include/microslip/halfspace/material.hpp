// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// Combined elastic constants of two quasi-identical bodies.
struct Material {
  double shear_modulus;  ///< G, in (0, inf)   [N/mm^2]
  double poisson_ratio;  ///< nu, in [0, 0.5]  [1]
};

/// \throws std::invalid_argument if a constant is outside the range above
void validate(const Material& material);

/// 2 (1 - nu) / G: strain per unit traction scale of the half-space in plane strain [mm^2/N].
double compliance(const Material& material);

}  // namespace microslip
