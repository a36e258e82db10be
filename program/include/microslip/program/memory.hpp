// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

namespace microslip::program {

/// Memory that this process can still allocate  [bytes]: available on the machine, and within
/// `ulimit -v` and `ulimit -d`.
double available_memory();

/// Rejects work that needs more memory than available, before the work begins.
/// \param key    key of the number that determines the memory, for the message
/// \param bytes  needed by the work
/// \throws std::invalid_argument with the needed and the available memory
void require_memory(const std::string& key, Eigen::Index value, double bytes);

/// From now on, allocating more than the available memory throws std::bad_alloc at once. Otherwise
/// Linux would grant the allocation, and kill this process, or another one, when the memory is
/// used.
void limit_memory();

}  // namespace microslip::program
