// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

namespace microslip::program {

/// What this process can still take  [bytes]: what the machine has available, and is left of
/// `ulimit -v` and `ulimit -d`.
double available_memory();

/// Rejects work that would end for want of memory before it begins.
/// \param key    of the number that decides, for the message
/// \param bytes  that the work takes
/// \throws std::invalid_argument that says what it takes and what there is
void require_memory(const std::string& key, Eigen::Index value, double bytes);

/// From now on, more than there is available is std::bad_alloc at once. Linux would promise it, and
/// end this process, or another one, when it is used.
void limit_memory();

}  // namespace microslip::program
