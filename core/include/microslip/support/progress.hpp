// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// A total that is not known before.
inline constexpr std::size_t unknown_total = 0;

/// Told after each finished case how many of how many are done.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace microslip
