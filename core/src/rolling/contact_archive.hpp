// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/rolling/contact_scale.hpp"
#include "microslip/support/archive.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

/// Writes or reads the size of a contact.
inline void archive_contact(Archive& archive, ContactScale& scale) {
  archive.number("half_width", scale.half_width);
  archive.number("bound", scale.bound);
  require(scale.half_width >= 0, "half_width", scale.half_width, "a number >= 0");
  require(scale.bound >= 0, "bound", scale.bound, "a number >= 0");
}

}  // namespace microslip
