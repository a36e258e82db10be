// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/contact.hpp"

#include "microslip/support/require.hpp"

namespace microslip {

void validate(const Contact& contact) {
  if (contact.has_unlike_bodies() && !contact.kernel.is_plane()) {
    reject("kernel", contact.kernel.name(), "plane for bodies of different material");
  }
}

}  // namespace microslip
