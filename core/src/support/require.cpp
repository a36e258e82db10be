// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/require.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "microslip/support/format.hpp"

namespace microslip {

void require(bool accepted_by_caller, std::string_view key, double value,
             std::string_view accepted) {
  if (accepted_by_caller && std::isfinite(value)) return;
  throw std::invalid_argument(std::string(key) + " = " + format_short(value) + ": expected " +
                              std::string(accepted));
}

void require_positive(std::string_view key, double value) {
  require(value > 0, key, value, "a number > 0");
}

}  // namespace microslip
