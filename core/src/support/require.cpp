// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/require.hpp"

#include <cmath>
#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

constexpr double least_size = 1e-50;
constexpr double largest_size = 1e50;

}  // namespace

void reject(std::string_view key, std::string_view text, std::string_view accepted) {
  throw BadParameter(key,
                     shown(key) + " = '" + shown(text) + "': expected " + std::string(accepted));
}

void require(bool accepted_by_caller, std::string_view key, double value,
             std::string_view accepted) {
  if (accepted_by_caller && std::isfinite(value)) return;
  throw BadParameter(
      key, std::string(key) + " = " + format_short(value) + ": expected " + std::string(accepted));
}

void require_positive(std::string_view key, double value) {
  require(value > 0, key, value, "a number > 0");
  require(value >= least_size && value <= largest_size, key, value, [] {
    return "a number from " + format_short(least_size) + " to " + format_short(largest_size);
  });
}

}  // namespace microslip
