// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/contact_scale.hpp"

#include <cmath>

#include "microslip/support/require.hpp"

namespace microslip {

ContactScale between(const ContactScale& from, const ContactScale& to, double part) {
  return {.half_width = std::lerp(from.half_width, to.half_width, part),
          .bound = std::lerp(from.bound, to.bound, part)};
}

ContactScale hertz_scale(double load_ratio, double friction_ratio) {
  require(load_ratio >= 0, "normal load ratio", load_ratio, "a number >= 0");
  require(friction_ratio >= 0, "friction ratio", friction_ratio, "a number >= 0");
  const double size = std::sqrt(load_ratio);
  return {.half_width = size, .bound = size * friction_ratio};
}

}  // namespace microslip
