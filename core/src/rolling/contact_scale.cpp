// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/contact_scale.hpp"

#include <cmath>

#include "microslip/friction/load.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

ContactScale between(const ContactScale& from, const ContactScale& to, double part) {
  return {.half_width = std::lerp(from.half_width, to.half_width, part),
          .bound = std::lerp(from.bound, to.bound, part)};
}

namespace {

void require_ratios(double load_ratio, double friction_ratio) {
  require(load_ratio >= 0, "normal load ratio", load_ratio, "a number >= 0");
  require(friction_ratio >= 0, "friction ratio", friction_ratio, "a number >= 0");
}

}  // namespace

ContactScale hertz_scale(double load_ratio, double friction_ratio) {
  require_ratios(load_ratio, friction_ratio);
  const double size = std::sqrt(load_ratio);
  return {.half_width = size, .bound = size * friction_ratio};
}

ContactScale hertz_point_scale(double load_ratio, double friction_ratio) {
  require_ratios(load_ratio, friction_ratio);
  const double size = std::cbrt(load_ratio);
  return {.half_width = size, .bound = size * friction_ratio};
}

void require_carried(double force, const ContactScale& contact, double full_sliding,
                     std::string_view name) {
  if (contact.carries()) {
    return require_below_full_sliding(force, full_sliding * contact.full_sliding(), name);
  }
  require(force == 0, name, force, "0 where bodies do not touch");
}

}  // namespace microslip
