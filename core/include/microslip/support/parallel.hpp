// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// Number of cores that this process may use: all cores of the machine, or fewer if the process is
/// bound to some of them.
int available_cores();

/// Calls do_case(0) ... do_case(count - 1) once each, on several threads; a thread that has
/// finished a case takes the next one. The result of a case must not depend on other cases, so that
/// the number of threads changes nothing.
/// \param threads  [1, inf)
/// \throws the exception of do_case, after which no other case begins; if several cases throw, the
///         exception of the lowest number
void for_each_case(std::size_t count, int threads, const std::function<void(std::size_t)>& do_case);

}  // namespace microslip
