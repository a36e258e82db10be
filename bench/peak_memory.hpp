// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace microslip::bench {

/// Largest resident set of a new process that does the work; it starts with what this one has
/// [byte]
/// \throws std::runtime_error if the work fails
double peak_memory(const std::function<void()>& work);

}  // namespace microslip::bench
