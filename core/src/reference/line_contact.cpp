// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/reference/line_contact.hpp"

#include <cmath>
#include <numbers>

#include "microslip/support/require.hpp"

namespace microslip {

LineContact::LineContact(const Material& material, double load, double curvature) {
  validate(material);
  require_positive("normal load", load);
  require_positive("curvature", curvature);
  const double stiffness = material.shear_modulus / (1 - material.poisson_ratio);  // E*
  half_width_ = std::sqrt(4 * load / (std::numbers::pi * stiffness * curvature));
  peak_ = 2 * load / (std::numbers::pi * half_width_);
}

}  // namespace microslip
