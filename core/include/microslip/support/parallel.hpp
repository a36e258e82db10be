// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// Cores that this process may use: those of the machine, or fewer if it is bound to some of them.
int available_cores();

/// Calls do_case(0) ... do_case(count - 1) once each, on several threads; a thread that is done
/// with one takes the next. The result of a case must not depend on others, so that the number of
/// threads changes nothing.
/// \param threads  [1, inf)
/// \throws what do_case throws: no other case begins then; if several throw, the exception of the
///         lowest number is passed on
void for_each_case(std::size_t count, int threads, const std::function<void(std::size_t)>& do_case);

}  // namespace microslip
