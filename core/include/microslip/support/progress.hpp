// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// Told after each finished case how many of how many are done.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace microslip
