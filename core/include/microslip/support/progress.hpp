// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// The total of a Progress that does not know it in advance.
inline constexpr std::size_t unknown_total = 0;

/// Called after each finished case with the number of finished cases and their total.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace microslip
