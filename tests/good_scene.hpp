// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace microslip {

/// The lines that good scenes of all problems have in common.
inline const std::string good_contact = R"(
material { shear_modulus 1
  poisson_ratio 0.28 }
contact { half_width 1
  peak_traction 1 }
kernel { type strip
  width 40 }
grid { elements 20 }
)";

}  // namespace microslip
