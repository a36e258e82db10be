// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/require.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

constexpr double least_size = 1e-50;
constexpr double largest_size = 1e50;

}  // namespace

void reject(std::string_view name, std::string_view text, std::string_view accepted) {
  throw BadParameter(name,
                     fmt::format("{} = '{}': expected {}", shown(name), shown(text), accepted));
}

void require(bool accepted_by_caller, std::string_view name, double value,
             std::string_view accepted) {
  if (accepted_by_caller && std::isfinite(value)) return;
  throw BadParameter(name,
                     fmt::format("{} = {}: expected {}", name, format_short(value), accepted));
}

void require_positive(std::string_view name, double value) {
  require(value > 0, name, value, "a number > 0");
  require(value >= least_size && value <= largest_size, name, value, [] {
    return fmt::format("a number from {} to {}", format_short(least_size),
                       format_short(largest_size));
  });
}

}  // namespace microslip
